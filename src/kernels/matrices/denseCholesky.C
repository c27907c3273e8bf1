// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseCholesky.H"
#include "laneArray.H"
#include "vectorClones.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::label;

//- A column of a panel
typedef Foam::fsi::laneArray<8> tileColumn;

constexpr int width = 8;


//- Four columns of the tile T of two panels: T -= sum_k a_k b_k^T
FSI_INLINE void subtractProducts
(
    const double* a,
    const double* b,
    const label nColumns,
    double* tile
)
{
    tileColumn sums[4];
    for (int c = 0; c < 4; ++c)
    {
        sums[c] = tileColumn::load(tile + width*c);
    }
    for (label k = 0; k < nColumns; ++k)
    {
        const tileColumn column(tileColumn::load(a + width*k));
        for (int c = 0; c < 4; ++c)
        {
            sums[c] = sums[c] - column*tileColumn(b[width*k + c]);
        }
    }
    for (int c = 0; c < 4; ++c)
    {
        sums[c].store(tile + width*c);
    }
}


//- T := T L^-T with the factored tile on the diagonal
FSI_INLINE void divideTile(const double* diagonal, double* tile)
{
    for (int c = 0; c < width; ++c)
    {
        tileColumn column(tileColumn::load(tile + width*c));
        for (int k = 0; k < c; ++k)
        {
            column =
                column
              - tileColumn::load(tile + width*k)
               *tileColumn(diagonal[width*k + c]);
        }
        (column*tileColumn(diagonal[width*c + c])).store(tile + width*c);
    }
}


//- Factor the tile on the diagonal; its diagonal is inverted
FSI_INLINE bool factorTile(double* tile)
{
    for (int c = 0; c < width; ++c)
    {
        for (int k = 0; k < c; ++k)
        {
            for (int r = c; r < width; ++r)
            {
                tile[width*c + r] -= tile[width*k + r]*tile[width*k + c];
            }
        }
        if (!(tile[width*c + c] > 0))
        {
            return false;
        }
        const double inverse = 1/std::sqrt(tile[width*c + c]);
        tile[width*c + c] = inverse;
        for (int r = c + 1; r < width; ++r)
        {
            tile[width*c + r] *= inverse;
        }
    }
    return true;
}


//- Factor panel i; the ones before it are factored. start: of each panel
FSI_AVX2_CLONES
bool factorPanel(double* values, const label i)
{
    const auto panel = [values](const label p)
    {
        return values + std::size_t(width*width)*p*(p + 1)/2;
    };
    double* own = panel(i);
    for (label j = 0; j <= i; ++j)
    {
        double* tile = own + width*width*j;
        for (int half = 0; half < 2; ++half)
        {
            subtractProducts
            (
                own, panel(j) + 4*half, width*j, tile + 4*width*half
            );
        }
        if (j < i)
        {
            divideTile(panel(j) + width*width*j, tile);
        }
    }
    return factorTile(own + width*width*i);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::denseCholesky::reset(const Eigen::MatrixXd& matrix)
{
    size_ = matrix.rows();
    nPanels_ = (size_ + width - 1)/width;
    values_.resize(start(nPanels_));
    for (label i = 0; i < nPanels_; ++i)
    {
        double* own = panel(i);
        for (label column = 0; column < width*(i + 1); ++column)
        {
            for (int r = 0; r < width; ++r)
            {
                // Behind the matrix the diagonal is 1
                const label row = width*i + r;
                own[width*column + r] =
                    row >= size_ || column >= size_
                  ? row == column
                  : row >= column ? matrix(row, column) : matrix(column, row);
            }
        }
    }
}


void Foam::fsi::denseCholesky::reset
(
    const denseCholesky& matrix,
    const double scale
)
{
    size_ = matrix.size_;
    nPanels_ = matrix.nPanels_;
    const std::size_t n = start(nPanels_);
    values_.resize(n);
    const double* from = matrix.values_.data();
    double* to = values_.data();
    for (std::size_t i = 0; i < n; ++i)
    {
        to[i] = scale*from[i];
    }
}


bool Foam::fsi::denseCholesky::factor()
{
    for (label i = 0; i < nPanels_; ++i)
    {
        if (!factorPanel(values_.data(), i))
        {
            return false;
        }
    }
    return true;
}


// ************************************************************************* //
