// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencilCycle.H"
#include "stencilRows.H"

namespace Foam
{
namespace fsi
{

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

template<bool threeD>
FSI_INLINE void restrictRows
(
    const stencil<float>& A,
    const float* b,
    const float* x,
    const stencil<float>& coarse,
    const levelShift shift,
    float* coarseB,
    float* work
)
{
    work[A.nx] = 0;
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        restrictRow<threeD>(A, r, b, x, coarse, shift, coarseB, work);
    }
}


FSI_INLINE void setZero(const stencil<float>& A, float* values)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        std::memset(values + A.row(r), 0, A.nx*sizeof(float));
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

FSI_VECTOR_CLONES
void restrictResidual
(
    const stencil<float>& A,
    const float* b,
    const float* x,
    const stencil<float>& coarse,
    const levelShift shift,
    float* coarseB,
    float* work
)
{
    setZero(coarse, coarseB);
    if (A.threeD)
    {
        restrictRows<true>(A, b, x, coarse, shift, coarseB, work);
    }
    else
    {
        restrictRows<false>(A, b, x, coarse, shift, coarseB, work);
    }
}


FSI_VECTOR_CLONES
void restrictSource
(
    const stencil<float>& A,
    const float* b,
    const stencil<float>& coarse,
    const levelShift shift,
    float* coarseB,
    float* work
)
{
    setZero(coarse, coarseB);
    work[A.nx] = 0;
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        std::memcpy(work, b + A.row(r), A.nx*sizeof(float));
        addRow
        (
            coarse.nx, shift.x, work, coarseB + coarseRow(A, r, coarse, shift)
        );
    }
}


FSI_VECTOR_CLONES
void addCoarse
(
    const stencil<float>& A,
    const stencil<float>& coarse,
    const levelShift shift,
    const float* coarseX,
    float* x
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        correctRow(A, r, coarse, shift, coarseX, x);
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
