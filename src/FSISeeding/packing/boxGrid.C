// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxGrid.H"
#include "openfoamVersion.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::boxGrid::boxGrid
(
    const boundBox& domain,
    const scalar cellSize,
    const direction nDims
)
:
    domain_(domain),
    nDims_(nDims),
    cellSize_(cellSize),
    nCells_(1, 1, 1),
    search_(0)
{
    const vector length(domain_.span());
    scalar size = 1, longest = 0;
    for (direction d = 0; d < nDims_; ++d)
    {
        size *= length[d];
        longest = max(longest, length[d]);
    }
    const scalar least = pow(size/1e6, 1.0/nDims_);
    cellSize_ = min(max(cellSize_, least), longest);
    for (direction d = 0; d < nDims_; ++d)
    {
        nCells_[d] = label(length[d]/cellSize_) + 1;
    }
    cells_.resize(cmptProduct(nCells_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::boxGrid::enter(const label objecti, const boundBox& box)
{
    while (lastSearch_.size() <= objecti)
    {
        lastSearch_.append(0);
    }
    forCells
    (
        box,
        [&](const label celli)
        {
            cells_[celli].append(objecti);
            return false;
        }
    );
}


void Foam::fsi::boxGrid::takeOut(const label objecti, const boundBox& box)
{
    forCells
    (
        box,
        [&](const label celli)
        {
            DynamicList<label>& cell = cells_[celli];
            std::swap(cell[indexOf(cell, objecti)], cell.last());
            cell.remove();
            return false;
        }
    );
}


// ************************************************************************* //
