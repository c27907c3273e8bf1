// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencilCycle.H"
#include "stencilRows.H"

namespace Foam
{
namespace fsi
{

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

// Each step follows one row (2D) or one plane (3D) behind the one before it,
// when all it reads is done and still in the cache
template<bool threeD>
FSI_INLINE void smoothAndRestrict
(
    const stencil<float>& A,
    const bool fromZero,
    const float* b,
    float* x,
    const stencil<float>& coarse,
    const levelShift shift,
    float* coarseB,
    float* work
)
{
    const int nRows = A.ny*A.nz;
    const int lag = threeD ? A.ny : 1;
    work[A.nx] = 0;
    for (int r = 0; r < nRows + 2*lag; ++r)
    {
        if (r < nRows && fromZero)
        {
            rowFromZero(A, r, 0, b, x);
        }
        else if (r < nRows)
        {
            rowSweep<threeD>(A, r, 0, b, x, work);
        }
        if (r >= lag && r < nRows + lag)
        {
            rowSweep<threeD>(A, r - lag, 1, b, x, work);
        }
        if (r >= 2*lag)
        {
            restrictRow<threeD>
            (
                A, r - 2*lag, b, x, coarse, shift, coarseB, work
            );
        }
    }
}


template<bool threeD>
FSI_INLINE void correctAndSmooth
(
    const stencil<float>& A,
    const float* b,
    float* x,
    const stencil<float>& coarse,
    const levelShift shift,
    const float* coarseX,
    float* work
)
{
    const int nRows = A.ny*A.nz;
    const int lag = threeD ? A.ny : 1;
    for (int r = 0; r < nRows + 2*lag; ++r)
    {
        if (r < nRows)
        {
            correctRow(A, r, coarse, shift, coarseX, x);
        }
        if (r >= lag && r < nRows + lag)
        {
            rowSweep<threeD>(A, r - lag, 1, b, x, work);
        }
        if (r >= 2*lag)
        {
            rowSweep<threeD>(A, r - 2*lag, 0, b, x, work);
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

FSI_VECTOR_CLONES
void downwards
(
    const stencil<float>& A,
    const bool fromZero,
    const float* b,
    float* x,
    const stencil<float>& coarse,
    const levelShift shift,
    float* coarseB,
    float* work
)
{
    for (int r = 0; r < coarse.ny*coarse.nz; ++r)
    {
        std::memset(coarseB + coarse.row(r), 0, coarse.nx*sizeof(float));
    }
    if (A.threeD)
    {
        smoothAndRestrict<true>
        (
            A, fromZero, b, x, coarse, shift, coarseB, work
        );
    }
    else
    {
        smoothAndRestrict<false>
        (
            A, fromZero, b, x, coarse, shift, coarseB, work
        );
    }
}


FSI_VECTOR_CLONES
void upwards
(
    const stencil<float>& A,
    const float* b,
    float* x,
    const stencil<float>& coarse,
    const levelShift shift,
    const float* coarseX,
    float* work
)
{
    if (A.threeD)
    {
        correctAndSmooth<true>(A, b, x, coarse, shift, coarseX, work);
    }
    else
    {
        correctAndSmooth<false>(A, b, x, coarse, shift, coarseX, work);
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
