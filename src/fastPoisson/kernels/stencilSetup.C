// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencilSetup.H"
#include "stencilRows.H"
#include <cmath>

namespace Foam
{
namespace fsi
{

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

// Sum of the face coefficients of cell i of a row
template<bool threeD, class Type>
FSI_INLINE Type faceSum(const stencil<Type>& A, const int place)
{
    Type sum =
        A.face[0][place] + A.face[0][place + 1]
      + A.face[1][place] + A.face[1][place + A.strideY];
    if (threeD)
    {
        sum += A.face[2][place] + A.face[2][place + A.strideZ];
    }
    return sum;
}


template<bool threeD>
FSI_INLINE void diagonalRow
(
    const stencil<float>& A,
    const int row,
    const float* __restrict__ excess,
    float* __restrict__ diagonal,
    float* __restrict__ inverse
)
{
    #pragma omp simd
    for (int i = row; i < row + A.nx; ++i)
    {
        const float value = faceSum<threeD>(A, i) + excess[i];
        const float filled = value > 0 ? 1.0f : 0.0f;
        diagonal[i] = value;
        inverse[i] = filled/(value + (1.0f - filled));
    }
}


template<bool threeD>
FSI_INLINE void rowSumRow
(
    const stencil<double>& A,
    const int row,
    double* __restrict__ result
)
{
    #pragma omp simd
    for (int i = row; i < row + A.nx; ++i)
    {
        result[i] = A.diagonal[i] - faceSum<threeD>(A, i);
    }
}


// Add the coefficients in the row's own direction of every aggregate's first
// cell
FSI_INLINE void addAlong
(
    const int nCoarse,
    const int shift,
    const float* __restrict__ face,
    float* __restrict__ coarse
)
{
    const float weight = shift ? 0.5f : 1.0f;
    const int step = 1 << shift;
    for (int i = 0; i < nCoarse; ++i)
    {
        coarse[i] += weight*face[step*i];
    }
}


// Add a weighted row to its aggregates'. work: see addRow
FSI_INLINE void addWeighted
(
    const stencil<float>& A,
    const int nCoarse,
    const int shift,
    const float weight,
    const float* __restrict__ row,
    float* __restrict__ coarse,
    float* __restrict__ work
)
{
    #pragma omp simd
    for (int i = 0; i < A.nx; ++i)
    {
        work[i] = weight*row[i];
    }
    work[A.nx] = 0;
    addRow(nCoarse, shift, work, coarse);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

FSI_VECTOR_CLONES
void setDiagonal
(
    const stencil<float>& A,
    const float* excess,
    float* diagonal,
    float* inverse
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        if (A.threeD)
        {
            diagonalRow<true>(A, A.row(r), excess, diagonal, inverse);
        }
        else
        {
            diagonalRow<false>(A, A.row(r), excess, diagonal, inverse);
        }
    }
}


FSI_VECTOR_CLONES
void rowSums(const stencil<double>& A, double* result)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        if (A.threeD)
        {
            rowSumRow<true>(A, A.row(r), result);
        }
        else
        {
            rowSumRow<false>(A, A.row(r), result);
        }
    }
}


FSI_VECTOR_CLONES
void setExcess
(
    const stencil<double>& A,
    const double factor,
    const double* __restrict__ rowSum,
    const double* __restrict__ added,
    float* __restrict__ excess
)
{
    const double* __restrict__ diagonal = A.diagonal;
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        const int row = A.row(r);
        #pragma omp simd
        for (int i = row; i < row + A.nx; ++i)
        {
            // Rounding of the row sum must not look like a Dirichlet patch
            const bool real = std::fabs(rowSum[i]) >= 1e-12*diagonal[i];
            const double value = (real ? rowSum[i] : 0.0) + added[i];
            excess[i] = float(factor*(value > 0 ? value : 0.0));
        }
    }
}


FSI_VECTOR_CLONES
void coarsenCoefficients
(
    const stencil<float>& A,
    const float* excess,
    const stencil<float>& coarse,
    const levelShift shift,
    float* const coarseFace[3],
    float* coarseExcess,
    float* work
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        const int j = r % A.ny;
        const int k = r/A.ny;
        const int row = A.row(r);
        const int to = coarseRow(A, r, coarse, shift);

        // A cell on its own is solved on this level
        #pragma omp simd
        for (int i = 0; i < A.nx; ++i)
        {
            const float sum = A.diagonal[row + i] - excess[row + i];
            work[i] = (sum > 0 ? 1.0f : 0.0f)*excess[row + i];
        }
        work[A.nx] = 0;
        addRow(coarse.nx, shift.x, work, coarseExcess + to);

        addAlong(coarse.nx, shift.x, A.face[0] + row, coarseFace[0] + to);
        if (((j >> shift.y) << shift.y) == j)
        {
            addWeighted
            (
                A, coarse.nx, shift.x, shift.y ? 0.5f : 1.0f,
                A.face[1] + row, coarseFace[1] + to, work
            );
        }
        if (A.threeD && ((k >> shift.z) << shift.z) == k)
        {
            addWeighted
            (
                A, coarse.nx, shift.x, shift.z ? 0.5f : 1.0f,
                A.face[2] + row, coarseFace[2] + to, work
            );
        }
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
