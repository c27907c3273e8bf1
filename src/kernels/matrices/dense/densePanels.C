// SPDX-License-Identifier: GPL-3.0-or-later

#include "densePanels.H"
#include "denseKernels.H"
#include "vectorClones.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::densePanels::pack(const Eigen::MatrixXd& x) const
{
    const label nGroups = (x.cols() + tileWidth - 1)/tileWidth;
    columns_.resize(tileWidth*nGroups*size_);
    for (label group = 0; group < nGroups; ++group)
    {
        double* to = columns_.data() + std::size_t(tileWidth)*size_*group;
        for (int c = 0; c < tileWidth; ++c)
        {
            const label column = tileWidth*group + c;
            if (column < x.cols())
            {
                const double* from = x.col(column).data();
                for (label k = 0; k < size_; ++k)
                {
                    to[tileWidth*k + c] = from[k];
                }
            }
            else
            {
                for (label k = 0; k < size_; ++k)
                {
                    to[tileWidth*k + c] = 0;
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::densePanels::densePanels(const Eigen::MatrixXd& matrix)
:
    size_(matrix.rows()),
    nPanels_((size_ + tileWidth - 1)/tileWidth)
{
    values_.resize(tileWidth*nPanels_*size_);
    for (label column = 0; column < size_; ++column)
    {
        for (label row = 0; row < size_; ++row)
        {
            const label panel = row/tileWidth;
            values_[tileWidth*(size_*panel + column) + row % tileWidth] =
                matrix(row, column);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::densePanels::multiply
(
    const Eigen::MatrixXd& x,
    Eigen::MatrixXd& y
) const
{
    pack(x);
    y.resize(size_, x.cols());
    const auto multiplyGroup = hasAVX512() ? multiplyWide : multiplyNarrow;
    constexpr int tileSize = tileWidth*tileWidth;
    alignas(tileWidth*sizeof(double)) double tiles[panelGroup*tileSize];
    for (label first = 0; first < nPanels_; first += panelGroup)
    {
        const label n = std::min(panelGroup, int(nPanels_ - first));
        for (label column = 0; column < x.cols(); column += tileWidth)
        {
            multiplyGroup
            (
                values_.data() + std::size_t(tileWidth)*size_*first,
                n,
                columns_.data() + std::size_t(column)*size_,
                size_,
                tiles
            );
            const label nColumns = std::min(tileWidth, int(x.cols() - column));
            const label nRows = std::min(tileWidth*n, size_ - tileWidth*first);
            for (label c = 0; c < nColumns; ++c)
            {
                double* to = y.col(column + c).data() + tileWidth*first;
                for (label r = 0; r < nRows; ++r)
                {
                    const label p = r/tileWidth;
                    to[r] = tiles[tileSize*p + tileWidth*c + r % tileWidth];
                }
            }
        }
    }
}


// ************************************************************************* //
