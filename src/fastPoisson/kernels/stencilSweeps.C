// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencil.H"
#include "vectorClones.H"
#include <cstring>

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
        const float mine = float((i + odd + 1) & 1);
        x[row + i] = mine*(b[row + i]*inverse[row + i]);
    }
}


// Red or black cells of row r. A cell of the colour reads none of its colour,
// and the others keep their value, by a product with 0 or 1: a condition would
// keep the loop from being vectorised where floating-point errors are trapped.
// By way of a row of work: loads that overlap what has just been stored would
// have to wait for it
template<bool threeD>
FSI_INLINE void rowSweep
(
    const stencil<float>& A,
    const int r,
    const int colour,
    const float* b,
    float* x,
    float* __restrict__ work
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
    float* value = x + row;

    #pragma omp simd
    for (int i = 0; i < A.nx; ++i)
    {
        float sum =
            source[i]
          + ax[i]*value[i - 1] + ax[i + 1]*value[i + 1]
          + ay[i]*value[i - sy] + ay[i + sy]*value[i + sy];
        if (threeD)
        {
            sum += az[i]*value[i - sz] + az[i + sz]*value[i + sz];
        }
        const float mine = float((i + odd + 1) & 1);
        work[i] = mine*(sum*inverse[i]) + (1.0f - mine)*value[i];
    }
    std::memcpy(value, work, A.nx*sizeof(float));
}


template<bool threeD>
FSI_INLINE void allRows
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x,
    float* work
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        rowSweep<threeD>(A, r, colour, b, x, work);
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
    float* x,
    float* work
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
                rowSweep<threeD>(A, r, colour, b, x, work);
            }
        }
        if (r >= lag)
        {
            rowSweep<threeD>(A, r - lag, 1 - colour, b, x, work);
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
    float* x,
    float* work
)
{
    if (A.threeD)
    {
        allRows<true>(A, colour, b, x, work);
    }
    else
    {
        allRows<false>(A, colour, b, x, work);
    }
}


FSI_VECTOR_CLONES
void sweepsFromZero
(
    const stencil<float>& A,
    const float* b,
    float* x,
    float* work
)
{
    if (A.threeD)
    {
        bothColours<true, true>(A, 0, b, x, work);
    }
    else
    {
        bothColours<false, true>(A, 0, b, x, work);
    }
}


FSI_VECTOR_CLONES
void sweeps
(
    const stencil<float>& A,
    const int colour,
    const float* b,
    float* x,
    float* work
)
{
    if (A.threeD)
    {
        bothColours<true, false>(A, colour, b, x, work);
    }
    else
    {
        bothColours<false, false>(A, colour, b, x, work);
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
