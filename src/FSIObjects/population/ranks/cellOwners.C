// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellOwners.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::cellOwners::here(point p) const
{
    if (!grid_)
    {
        return rankIn() == 0;
    }
    const boundBox box(grid_->bounds());
    const scalar half = 0.5*grid_->spacing();
    for (direction d = 0; d < grid_->nDims(); ++d)
    {
        if (!(grid_->period()[d] > 0))
        {
            p[d] = min(max(p[d], box.min()[d] + half), box.max()[d] - half);
        }
    }
    return grid_->findCell(p) >= 0;
}


Foam::labelList Foam::fsi::cellOwners::ranksAt(const pointField& places) const
{
    labelList ranks(places.size(), nRanksIn());
    forAll(ranks, i)
    {
        if (here(places[i]))
        {
            ranks[i] = rankIn();
        }
    }
    combineOverRanks(ranks, minEqOp<label>());
    for (label& rank : ranks)
    {
        rank = rank % nRanksIn();
    }
    return ranks;
}


Foam::fsi::reachBoxes Foam::fsi::cellOwners::reach(const scalar distance) const
{
    boundBox cells(point::max, point::min);
    for (const point& p : grid_->mesh().points())
    {
        cells = boundBox(min(cells.min(), p), max(cells.max(), p));
    }
    return reachBoxes(cells, grid_->period(), distance);
}


// ************************************************************************* //
