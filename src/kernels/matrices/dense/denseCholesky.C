// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseCholesky.H"
#include "denseKernels.H"
#include "vectorClones.H"

#include <algorithm>

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
    const auto factorGroup = hasAVX512() ? factorWide : factorNarrow;
    for (label first = 0; first < nPanels_; first += panelGroup)
    {
        const label last = std::min(first + panelGroup, nPanels_);
        if (!factorGroup(values_.data(), first, last))
        {
            return false;
        }
    }
    return true;
}


void Foam::fsi::denseCholesky::solve
(
    const label nColumns,
    double* columns
) const
{
    const auto solve = hasAVX512() ? solveWide : solveNarrow;
    solve(values_.data(), nPanels_, nColumns, columns);
}


// ************************************************************************* //
