// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseCholesky.H"
#include "laneArray.H"
#include "vectorClones.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::label;

//- A column of a panel
typedef Foam::fsi::laneArray<8> tileColumn;

constexpr int width = 8;


//- x := L^-1 x, columns of width*nPanels rows each
template<int nColumns>
FSI_INLINE void solveForward
(
    const double* own,
    const label nPanels,
    double* x
)
{
    const label nRows = width*nPanels;
    for (label i = 0; i < nPanels; ++i)
    {
        tileColumn sums[nColumns];
        for (int c = 0; c < nColumns; ++c)
        {
            sums[c] = tileColumn::load(x + nRows*c + width*i);
        }
        for (label k = 0; k < width*i; ++k)
        {
            const tileColumn column(tileColumn::load(own + width*k));
            for (int c = 0; c < nColumns; ++c)
            {
                sums[c] = sums[c] - column*tileColumn(x[nRows*c + k]);
            }
        }
        const double* tile = own + width*width*i;
        for (int c = 0; c < nColumns; ++c)
        {
            double* b = x + nRows*c + width*i;
            sums[c].store(b);
            for (int k = 0; k < width; ++k)
            {
                b[k] *= tile[width*k + k];
                for (int r = k + 1; r < width; ++r)
                {
                    b[r] -= tile[width*k + r]*b[k];
                }
            }
        }
        own += width*width*(i + 1);
    }
}


//- x := L^-T x; end: that of the values
template<int nColumns>
FSI_INLINE void solveBackward
(
    const double* end,
    const label nPanels,
    double* x
)
{
    const label nRows = width*nPanels;
    const double* own = end;
    for (label i = nPanels - 1; i >= 0; --i)
    {
        own -= width*width*(i + 1);
        const double* tile = own + width*width*i;
        tileColumn solved[nColumns];
        for (int c = 0; c < nColumns; ++c)
        {
            double* b = x + nRows*c + width*i;
            for (int k = width - 1; k >= 0; --k)
            {
                for (int r = k + 1; r < width; ++r)
                {
                    b[k] -= tile[width*k + r]*b[r];
                }
                b[k] *= tile[width*k + k];
            }
            solved[c] = tileColumn::load(b);
        }
        for (label k = 0; k < width*i; ++k)
        {
            const tileColumn column(tileColumn::load(own + width*k));
            for (int c = 0; c < nColumns; ++c)
            {
                const tileColumn products(column*solved[c]);
                double sum = 0;
                for (int r = 0; r < width; ++r)
                {
                    sum += products[r];
                }
                x[nRows*c + k] -= sum;
            }
        }
    }
}


FSI_AVX2_CLONES
void solveColumns
(
    const double* values,
    const label nPanels,
    const label nColumns,
    double* x
)
{
    const double* end =
        values + std::size_t(width*width)*nPanels*(nPanels + 1)/2;
    if (nColumns == 3)
    {
        solveForward<3>(values, nPanels, x);
        solveBackward<3>(end, nPanels, x);
    }
    else
    {
        solveForward<2>(values, nPanels, x);
        solveBackward<2>(end, nPanels, x);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::denseCholesky::solve
(
    Eigen::Ref<Eigen::MatrixXd> x,
    laneField& work
) const
{
    const label nRows = width*nPanels_;
    work.resize(nRows*x.cols());
    for (label c = 0; c < x.cols(); ++c)
    {
        std::copy_n(x.col(c).data(), size_, work.data() + nRows*c);
        std::fill_n(work.data() + nRows*c + size_, nRows - size_, 0.0);
    }
    solveColumns(values_.data(), nPanels_, x.cols(), work.data());
    for (label c = 0; c < x.cols(); ++c)
    {
        std::copy_n(work.data() + nRows*c, size_, x.col(c).data());
    }
}


// ************************************************************************* //
