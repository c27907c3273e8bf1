// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencil.H"
#include "vectorClones.H"

namespace Foam
{
namespace fsi
{

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

// Red or black cells of row r from x = 0
FSI_INLINE void rowFromZero
(
    const stencil<float>& A,
    const int r,
    const int colour,
    const float* __restrict__ b,
    float* __restrict__ x
)
{
    const int row = A.row(r);
    const int odd = A.offset(r, colour);
    const float* inverse = A.inverse;
    #pragma omp simd
    for (int i = 0; i < A.nx; ++i)
    {
        const float value = b[row + i]*inverse[row + i];
        x[row + i] = ((i + odd) & 1) ? 0.0f : value;
    }
}


// Red or black cells of row r. The iterations are independent: a cell of the
// colour reads none of its colour, and the others keep their value
template<bool threeD>
FSI_INLINE void rowSweep
(
    const stencil<float>& A,
    const int r,
    const int colour,
    const float* b,
    float* x
)
{
    const int row = A.row(r);
    const int odd = A.offset(r, colour);
    const int sy = A.strideY;
    const int sz = A.strideZ;
    const float* __restrict__ ax = A.face[0] + row;
    const float* __restrict__ ay = A.face[1] + row;
    const float* __restrict__ az = A.face[2] + row;
    const float* __restrict__ inverse = A.inverse + row;
    const float* __restrict__ source = b + row;
    const float* old = unrelated(x + row);
    float* value = x + row;

    #pragma omp simd
    for (int i = 0; i < A.nx; ++i)
    {
        float sum =
            source[i]
          + ax[i]*old[i - 1] + ax[i + 1]*old[i + 1]
          + ay[i]*old[i - sy] + ay[i + sy]*old[i + sy];
        if (threeD)
        {
            sum += az[i]*old[i - sz] + az[i + sz]*old[i + sz];
        }
        sum *= inverse[i];
        value[i] = ((i + odd) & 1) ? old[i] : sum;
    }
}


template<bool threeD>
FSI_INLINE void allRows
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        rowSweep<threeD>(A, r, colour, b, x);
    }
}


// The second colour follows one row (2D) or one plane (3D) behind the first,
// when all it reads is done and still in the cache
template<bool threeD, bool fromZero>
FSI_INLINE void bothColours
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x
)
{
    const int nRows = A.ny*A.nz;
    const int lag = threeD ? A.ny : 1;
    for (int r = 0; r < nRows + lag; ++r)
    {
        if (r < nRows)
        {
            if (fromZero)
            {
                rowFromZero(A, r, colour, b, x);
            }
            else
            {
                rowSweep<threeD>(A, r, colour, b, x);
            }
        }
        if (r >= lag)
        {
            rowSweep<threeD>(A, r - lag, 1 - colour, b, x);
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

FSI_VECTOR_CLONES
void sweepFromZero
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        rowFromZero(A, r, colour, b, x);
    }
}


FSI_VECTOR_CLONES
void sweep
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x
)
{
    if (A.threeD)
    {
        allRows<true>(A, colour, b, x);
    }
    else
    {
        allRows<false>(A, colour, b, x);
    }
}


FSI_VECTOR_CLONES
void sweepsFromZero(const stencil<float>& A, const float* b, float* x)
{
    if (A.threeD)
    {
        bothColours<true, true>(A, 0, b, x);
    }
    else
    {
        bothColours<false, true>(A, 0, b, x);
    }
}


FSI_VECTOR_CLONES
void sweeps
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x
)
{
    if (A.threeD)
    {
        bothColours<true, false>(A, colour, b, x);
    }
    else
    {
        bothColours<false, false>(A, colour, b, x);
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
