// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencil.H"
#include "vectorClones.H"
#include <cstring>

namespace Foam
{
namespace fsi
{

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

// residual = b - A x of one row
template<bool threeD>
FSI_INLINE void rowResidual
(
    const stencil<float>& A,
    const int row,
    const float* b,
    const float* x,
    float* __restrict__ residual
)
{
    const int sy = A.strideY;
    const int sz = A.strideZ;
    const float* __restrict__ ax = A.face[0] + row;
    const float* __restrict__ ay = A.face[1] + row;
    const float* __restrict__ az = A.face[2] + row;
    const float* __restrict__ diagonal = A.diagonal + row;
    const float* __restrict__ source = b + row;
    const float* __restrict__ value = x + row;

    #pragma omp simd
    for (int i = 0; i < A.nx; ++i)
    {
        float sum =
            source[i] - diagonal[i]*value[i]
          + ax[i]*value[i - 1] + ax[i + 1]*value[i + 1]
          + ay[i]*value[i - sy] + ay[i + sy]*value[i + sy];
        if (threeD)
        {
            sum += az[i]*value[i - sz] + az[i + sz]*value[i + sz];
        }
        residual[i] = sum;
    }
}


// Add a row's residual to its aggregates'
FSI_INLINE void addRow
(
    const int nCoarse,
    const int shift,
    const float* __restrict__ residual,
    float* __restrict__ coarse
)
{
    if (shift)
    {
        #pragma omp simd
        for (int i = 0; i < nCoarse; ++i)
        {
            coarse[i] += residual[2*i] + residual[2*i + 1];
        }
    }
    else
    {
        #pragma omp simd
        for (int i = 0; i < nCoarse; ++i)
        {
            coarse[i] += residual[i];
        }
    }
}


// Place of the first cell of the coarse row that a fine row belongs to
FSI_INLINE int coarseRow
(
    const stencil<float>& A,
    const int r,
    const stencil<float>& coarse,
    const levelShift shift
)
{
    return
        coarse.first
      + coarse.strideY*((r % A.ny) >> shift.y)
      + coarse.strideZ*((r/A.ny) >> shift.z);
}


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
    // A last cell without a partner
    work[A.nx] = 0;
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        rowResidual<threeD>(A, A.row(r), b, x, work);
        addRow
        (
            coarse.nx, shift.x, work,
            coarseB + coarseRow(A, r, coarse, shift)
        );
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
    for (int r = 0; r < coarse.ny*coarse.nz; ++r)
    {
        std::memset(coarseB + coarse.row(r), 0, coarse.nx*sizeof(float));
    }
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
        const float* __restrict__ from =
            coarseX + coarseRow(A, r, coarse, shift);
        float* __restrict__ to = x + A.row(r);
        if (shift.x)
        {
            #pragma omp simd
            for (int i = 0; i < A.nx/2; ++i)
            {
                to[2*i] += from[i];
                to[2*i + 1] += from[i];
            }
            if (A.nx & 1)
            {
                to[A.nx - 1] += from[A.nx/2];
            }
        }
        else
        {
            #pragma omp simd
            for (int i = 0; i < A.nx; ++i)
            {
                to[i] += from[i];
            }
        }
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
