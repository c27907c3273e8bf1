// SPDX-License-Identifier: GPL-3.0-or-later

#include "nodeLayout.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::nodeLayout::nodeLayout(const direction nDims)
:
    nDims_(nDims),
    nSurface_(0),
    ranks_(nullptr)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::nodeLayout::zero
(
    const bool boundary,
    groupNodal& values
) const
{
    values.resize(groups_.size());
    forAll(groups_, groupi)
    {
        const group& g = groups_[groupi];
        values[groupi].setZero
        (
            boundary ? g.nBoundary : g.nNodes,
            nDims_*g.nCopies
        );
    }
}


void Foam::fsi::nodeLayout::setBoundaryRows
(
    const vectorField& surface,
    groupNodal& values
) const
{
    forAll(groups_, groupi)
    {
        const group& g = groups_[groupi];
        for (label copyi = 0; copyi < g.nCopies; ++copyi)
        {
            const label first = g.start + g.nBoundary*copyi;
            for (direction d = 0; d < nDims_; ++d)
            {
                auto column = values[groupi].col(nDims_*copyi + d);
                for (label i = 0; i < g.nBoundary; ++i)
                {
                    column[i] = surface[first + i][d];
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::nodeLayout::clear()
{
    groups_.clear();
    nSurface_ = 0;
    ranks_ = nullptr;
}


void Foam::fsi::nodeLayout::append
(
    const label nNodes,
    const label nBoundary,
    const label nCopies
)
{
    groups_.append({nNodes, nBoundary, nCopies, nSurface_});
    nSurface_ += nBoundary*nCopies;
}


void Foam::fsi::nodeLayout::appendGuests
(
    const label nNodes,
    const objectRanks& ranks
)
{
    nSurface_ += nNodes;
    ranks_ = &ranks;
}


Foam::label Foam::fsi::nodeLayout::nNodes() const
{
    label n = 0;
    for (const group& g : groups_)
    {
        n += g.nNodes*g.nCopies;
    }
    return n;
}


void Foam::fsi::nodeLayout::add(const groupNodal& values, groupNodal& sum)
{
    forAll(sum, groupi)
    {
        sum[groupi] += values[groupi];
    }
}


void Foam::fsi::nodeLayout::toGroups
(
    const vectorField& surface,
    groupNodal& values
) const
{
    zero(false, values);
    setBoundaryRows(surface, values);
}


void Foam::fsi::nodeLayout::toBoundary
(
    const vectorField& surface,
    groupNodal& values
) const
{
    values.resize(groups_.size());
    forAll(groups_, groupi)
    {
        const group& g = groups_[groupi];
        values[groupi].resize(g.nBoundary, nDims_*g.nCopies);
    }
    setBoundaryRows(surface, values);
}


void Foam::fsi::nodeLayout::toSurface
(
    const groupNodal& values,
    vectorField& surface,
    const bool spreads
) const
{
    surface.setSize(nSurface_);
    forAll(groups_, groupi)
    {
        const group& g = groups_[groupi];
        const Eigen::MatrixXd& b = values[groupi];
        for (label copyi = 0; copyi < g.nCopies; ++copyi)
        {
            const label first = g.start + g.nBoundary*copyi;
            const scalar* x = b.col(nDims_*copyi).data();
            const scalar* y = x + b.rows();
            const scalar* z = nDims_ == 3 ? y + b.rows() : nullptr;
            for (label i = 0; i < g.nBoundary; ++i)
            {
                surface[first + i] = vector(x[i], y[i], z ? z[i] : 0);
            }
        }
    }
    if (ranks_ && spreads)
    {
        ranks_->spread({objectRanks::values::ofNodes(surface)});
    }
}


void Foam::fsi::nodeLayout::wallsToSurface
(
    const groupNodal& values,
    vectorField& surface
) const
{
    toSurface(values, surface, false);
    if (ranks_)
    {
        const label own =
            groups_.empty()
          ? 0
          : groups_.last().start
          + groups_.last().nBoundary*groups_.last().nCopies;
        std::fill(surface.begin() + own, surface.end(), vector::zero);
        ranks_->spread({objectRanks::values::ofWalls(surface)});
    }
}


Foam::fsi::nodeLayout::groupNodal Foam::fsi::nodeLayout::boundaryOf
(
    const groupNodal& values
) const
{
    groupNodal boundary(groups_.size());
    forAll(groups_, groupi)
    {
        boundary[groupi] = values[groupi].topRows(groups_[groupi].nBoundary);
    }
    return boundary;
}


// ************************************************************************* //
