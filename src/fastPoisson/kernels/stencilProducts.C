// SPDX-License-Identifier: GPL-3.0-or-later

#include "stencilProducts.H"
#include "vectorClones.H"
#include <cmath>

namespace Foam
{
namespace fsi
{

// * * * * * * * * * * * * * Static Helper Functions * * * * * * * * * * * * //

// Ap = A p in one row; returns p.Ap
template<bool threeD>
FSI_INLINE double rowProduct
(
    const stencil<double>& A,
    const int row,
    const double* p,
    double* Ap
)
{
    const int sy = A.strideY;
    const int sz = A.strideZ;
    const double* __restrict__ ax = A.face[0] + row;
    const double* __restrict__ ay = A.face[1] + row;
    const double* __restrict__ az = A.face[2] + row;
    const double* __restrict__ diagonal = A.diagonal + row;
    const double* __restrict__ value = p + row;
    double* __restrict__ result = Ap + row;

    double dot = 0;
    #pragma omp simd reduction(+:dot)
    for (int i = 0; i < A.nx; ++i)
    {
        double sum =
            diagonal[i]*value[i]
          - ax[i]*value[i - 1] - ax[i + 1]*value[i + 1]
          - ay[i]*value[i - sy] - ay[i + sy]*value[i + sy];
        if (threeD)
        {
            sum -= az[i]*value[i - sz] + az[i + sz]*value[i + sz];
        }
        result[i] = sum;
        dot += sum*value[i];
    }
    return dot;
}


template<bool threeD>
FSI_INLINE double allProducts
(
    const stencil<double>& A,
    const double* p,
    double* Ap
)
{
    double dot = 0;
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        dot += rowProduct<threeD>(A, A.row(r), p, Ap);
    }
    return dot;
}


template<class Type>
FSI_INLINE double allDots
(
    const stencil<double>& A,
    const double* __restrict__ r,
    const Type* __restrict__ z
)
{
    double total = 0;
    for (int rowi = 0; rowi < A.ny*A.nz; ++rowi)
    {
        const int row = A.row(rowi);
        double dot = 0;
        #pragma omp simd reduction(+:dot)
        for (int i = row; i < row + A.nx; ++i)
        {
            dot += r[i]*z[i];
        }
        total += dot;
    }
    return total;
}


// p = factor*z + beta*p in one row
FSI_INLINE void rowDirection
(
    const stencil<double>& A,
    const int row,
    const double factor,
    const float* __restrict__ z,
    const double beta,
    double* __restrict__ p
)
{
    #pragma omp simd
    for (int i = row; i < row + A.nx; ++i)
    {
        p[i] = factor*z[i] + beta*p[i];
    }
}


// The product follows one row (2D) or one plane (3D) behind the direction
template<bool threeD>
FSI_INLINE double allDirectionsAndProducts
(
    const stencil<double>& A,
    const double factor,
    const float* z,
    const double beta,
    double* p,
    double* Ap
)
{
    const int nRows = A.ny*A.nz;
    const int lag = threeD ? A.ny : 1;
    double dot = 0;
    for (int r = 0; r < nRows + lag; ++r)
    {
        if (r < nRows)
        {
            rowDirection(A, A.row(r), factor, z, beta, p);
        }
        if (r >= lag)
        {
            dot += rowProduct<threeD>(A, A.row(r - lag), p, Ap);
        }
    }
    return dot;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

FSI_VECTOR_CLONES
double product(const stencil<double>& A, const double* p, double* Ap)
{
    return
        A.threeD
      ? allProducts<true>(A, p, Ap)
      : allProducts<false>(A, p, Ap);
}


FSI_VECTOR_CLONES
double dotProduct(const stencil<double>& A, const double* r, const float* z)
{
    return allDots(A, r, z);
}


FSI_VECTOR_CLONES
double dotProduct(const stencil<double>& A, const double* r, const double* z)
{
    return allDots(A, r, z);
}


FSI_VECTOR_CLONES
void updateDirection
(
    const stencil<double>& A,
    const double factor,
    const float* z,
    const double beta,
    double* p
)
{
    for (int r = 0; r < A.ny*A.nz; ++r)
    {
        rowDirection(A, A.row(r), factor, z, beta, p);
    }
}


FSI_VECTOR_CLONES
double directionAndProduct
(
    const stencil<double>& A,
    const double factor,
    const float* z,
    const double beta,
    double* p,
    double* Ap
)
{
    return
        A.threeD
      ? allDirectionsAndProducts<true>(A, factor, z, beta, p, Ap)
      : allDirectionsAndProducts<false>(A, factor, z, beta, p, Ap);
}


FSI_VECTOR_CLONES
double updateSolution
(
    const stencil<double>& A,
    const double alpha,
    const double* __restrict__ p,
    const double* __restrict__ Ap,
    double* __restrict__ x,
    double* __restrict__ r
)
{
    double total = 0;
    for (int rowi = 0; rowi < A.ny*A.nz; ++rowi)
    {
        const int row = A.row(rowi);
        double sum = 0;
        #pragma omp simd reduction(+:sum)
        for (int i = row; i < row + A.nx; ++i)
        {
            x[i] += alpha*p[i];
            r[i] -= alpha*Ap[i];
            sum += std::fabs(r[i]);
        }
        total += sum;
    }
    return total;
}


FSI_VECTOR_CLONES
void scaled
(
    const stencil<double>& A,
    const double factor,
    const double* __restrict__ r,
    float* __restrict__ b
)
{
    for (int rowi = 0; rowi < A.ny*A.nz; ++rowi)
    {
        const int row = A.row(rowi);
        #pragma omp simd
        for (int i = row; i < row + A.nx; ++i)
        {
            b[i] = float(factor*r[i]);
        }
    }
}


} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
