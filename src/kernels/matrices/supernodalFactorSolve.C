// SPDX-License-Identifier: GPL-3.0-or-later

#include "supernodalFactor.H"
#include "laneReference.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Rows (forward) or columns (backward) whose sums are in registers together
template<class Array>
constexpr int together()
{
    constexpr int n = 12/Array::nPacks;
    return n > 4 ? 4 : n < 1 ? 1 : n;
}


//- Some rows of the forward solution: x[rows] -= values x[first ...]
template<class Array, int n>
FSI_INLINE void forwardRows
(
    const double* values,
    const label* rows,
    const label first,
    const label nColumns,
    double* x
)
{
    Array sums[n];
    #pragma GCC unroll 4
    for (int r = 0; r < n; ++r)
    {
        sums[r] = at<Array>(x, rows[r]);
    }
    for (label k = 0; k < nColumns; ++k)
    {
        const Array own = at<Array>(x, first + k);
        #pragma GCC unroll 4
        for (int r = 0; r < n; ++r)
        {
            sums[r] = sums[r] - own*values[nColumns*r + k];
        }
    }
    #pragma GCC unroll 4
    for (int r = 0; r < n; ++r)
    {
        to<Array>(x, rows[r]) = sums[r];
    }
}


//- Some columns of the backward solution: x[column ...] -= values^T x[rows]
template<class Array, int n>
FSI_INLINE void backwardColumns
(
    const double* values,
    const label* rows,
    const label nRows,
    const label column,
    const label nColumns,
    double* x
)
{
    Array sums[n];
    #pragma GCC unroll 4
    for (int c = 0; c < n; ++c)
    {
        sums[c] = at<Array>(x, column + c);
    }
    for (label r = 0; r < nRows; ++r)
    {
        const Array other = at<Array>(x, rows[r]);
        #pragma GCC unroll 4
        for (int c = 0; c < n; ++c)
        {
            sums[c] = sums[c] - other*values[nColumns*r + c];
        }
    }
    #pragma GCC unroll 4
    for (int c = 0; c < n; ++c)
    {
        to<Array>(x, column + c) = sums[c];
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Array>
[[gnu::always_inline]]
inline void Foam::fsi::supernodalFactor::forward(double* x) const
{
    constexpr int n = together<Array>();
    for (label s = 0; s < first_.size() - 1; ++s)
    {
        const label first = first_[s];
        const label nColumns = first_[s + 1] - first;
        const double* values = &values_[block_[s]];
        for (label k = 0; k < nColumns; ++k)
        {
            Array sum = at<Array>(x, first + k);
            for (label l = 0; l < k; ++l)
            {
                sum = sum - at<Array>(x, first + l)*values[l];
            }
            to<Array>(x, first + k) = sum*values[k];
            values += nColumns;
        }
        const label* rows = rows_.cdata() + start_[s];
        const label* end = rows_.cdata() + start_[s + 1];
        for (; rows + n <= end; rows += n, values += n*nColumns)
        {
            forwardRows<Array, n>(values, rows, first, nColumns, x);
        }
        for (; rows < end; ++rows, values += nColumns)
        {
            forwardRows<Array, 1>(values, rows, first, nColumns, x);
        }
    }
}


template<class Array>
[[gnu::always_inline]]
inline void Foam::fsi::supernodalFactor::backward(double* x) const
{
    constexpr int n = together<Array>();
    for (label s = first_.size() - 2; s >= 0; --s)
    {
        const label first = first_[s];
        const label nColumns = first_[s + 1] - first;
        const double* triangle = &values_[block_[s]];
        const double* values = triangle + nColumns*nColumns;
        const label* rows = rows_.cdata() + start_[s];
        const label nRows = start_[s + 1] - start_[s];
        label c = 0;
        for (; c + n <= nColumns; c += n)
        {
            backwardColumns<Array, n>
            (
                values + c, rows, nRows, first + c, nColumns, x
            );
        }
        for (; c < nColumns; ++c)
        {
            backwardColumns<Array, 1>
            (
                values + c, rows, nRows, first + c, nColumns, x
            );
        }
        for (label k = nColumns - 1; k >= 0; --k)
        {
            Array sum = at<Array>(x, first + k);
            for (label l = nColumns - 1; l > k; --l)
            {
                sum = sum - at<Array>(x, first + l)*triangle[nColumns*l + k];
            }
            to<Array>(x, first + k) = sum*triangle[(nColumns + 1)*k];
        }
    }
}


template<class Array>
[[gnu::always_inline]]
inline void Foam::fsi::supernodalFactor::solve(double* x) const
{
    forward<Array>(x);
    backward<Array>(x);
}


FSI_AVX512
void Foam::fsi::supernodalFactor::solveWide(const int width, double* x) const
{
    switch (width)
    {
        case 24: solve<laneArray<24, 8>>(x); break;
        case 16: solve<laneArray<16, 8>>(x); break;
        default: solve<laneArray<8, 8>>(x);
    }
}


FSI_AVX2_CLONES
void Foam::fsi::supernodalFactor::solveNarrow(const int width, double* x) const
{
    switch (width)
    {
        case 24: solve<laneArray<24>>(x); break;
        case 16: solve<laneArray<16>>(x); break;
        case 12: solve<laneArray<12>>(x); break;
        case 8: solve<laneArray<8>>(x); break;
        case 6: solve<laneArray<6>>(x); break;
        case 4: solve<laneArray<4>>(x); break;
        case 3: solve<laneArray<3>>(x); break;
        default: solve<laneArray<2>>(x);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::supernodalFactor::solveRows(const int width, double* x) const
{
    if (width % 8 == 0 && hasAVX512())
    {
        solveWide(width, x);
    }
    else
    {
        solveNarrow(width, x);
    }
}


// ************************************************************************* //
