// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockPartition.H"
#include "latticeRanks.H"
#include "openfoamVersion.H"
#include "boundBox.H"
#include <algorithm>
#include "DynamicList.H"
#include <set>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::blockPartition::setCuts
(
    const List<boxEnds>& boxes,
    const labelVector& n,
    const label step
)
{
    for (direction d = 0; d < 3; ++d)
    {
        // Lower sides that lie within a step are one cut, amid them and the
        // upper sides of the boxes before
        std::set<label> sides;
        for (const boxEnds& ends : boxes)
        {
            sides.insert(ends[2*d]);
        }
        DynamicList<label> cuts;
        cuts.append(0);
        for (auto first = sides.begin(); first != sides.end();)
        {
            const auto last = sides.upper_bound(*first + step);
            label low = *first;
            label high = *std::prev(last);
            for (const boxEnds& ends : boxes)
            {
                const label end = ends[2*d + 1];
                if (end < n[d] && mag(end - low) <= 2*step)
                {
                    high = max(high, end);
                }
            }
            if (low > step)
            {
                cuts.append((low + high)/2);
            }
            first = last;
        }
        cuts.append(n[d]);
        cuts_[d] = cuts;
    }
}


bool Foam::fsi::blockPartition::placeBoxes
(
    const List<boxEnds>& boxes,
    const label step
)
{
    rank_.setSize(boxes.size());
    rank_ = -1;
    forAll(boxes, ranki)
    {
        labelVector position;
        for (direction d = 0; d < 3; ++d)
        {
            const label low = boxes[ranki][2*d];
            const label high = boxes[ranki][2*d + 1];
            position[d] = 0;
            while
            (
                position[d] + 1 < nBoxes(d)
             && cuts_[d][position[d] + 1] <= low + step
            )
            {
                ++position[d];
            }
            if (cuts_[d][position[d] + 1] < high - step)
            {
                return false;
            }
        }
        rank_[box(position)] = ranki;
    }
    return !isIn(rank_, label(-1));
}


bool Foam::fsi::blockPartition::takeBoxes
(
    const cartesianMap& map,
    const label comm,
    const label step
)
{
    boxEnds mine(label(0));
    for (direction d = 0; d < 3; ++d)
    {
        label low = labelMax;
        label high = 0;
        for (const labelVector& cell : map.cells())
        {
            low = min(low, cell[d]);
            high = max(high, cell[d] + 1);
        }
        mine[2*d] = low;
        mine[2*d + 1] = high;
    }
    const List<boxEnds> boxes(gatherOverRanks(mine, comm));
    for (const boxEnds& ends : boxes)
    {
        if (ends[0] >= ends[1])
        {
            // A rank without cells has no box
            return false;
        }
    }

    setCuts(boxes, map.n(), step);
    return
        nBoxes(0)*nBoxes(1)*nBoxes(2) == boxes.size()
     && placeBoxes(boxes, step);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::blockPartition::blockPartition(const cartesianMap& map)
:
    cyclic_(map.cyclic())
{
    const label comm = map.mesh().comm();
    const label nRanks = nRanksIn(comm);

    for (direction d = 0; d < 3; ++d)
    {
        pad_[d] = d < 2 || map.n()[d] > 1;
    }
    if
    (
        nRanks == 1
     || !(takeBoxes(map, comm, 0) || takeBoxes(map, comm, largestStep))
    )
    {
        makeBoxes(map, nRanks);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::blockLayout Foam::fsi::blockPartition::layout
(
    const label rank
) const
{
    const label mine = indexOf(rank_, rank);
    if (mine < 0)
    {
        return blockLayout
        (
            labelVector(0, 0, 0), labelVector(0, 0, 0), pad_,
            FixedList<label, 6>(label(-1))
        );
    }
    const labelVector position
    (
        mine % nBoxes(0),
        (mine/nBoxes(0)) % nBoxes(1),
        mine/(nBoxes(0)*nBoxes(1))
    );

    labelVector n, start;
    FixedList<label, 6> neighbour(label(-1));
    for (direction d = 0; d < 3; ++d)
    {
        start[d] = cuts_[d][position[d]];
        n[d] = cuts_[d][position[d] + 1] - start[d];

        for (label side = 0; side < 2 && pad_[d]; ++side)
        {
            labelVector next(position);
            next[d] += 2*side - 1;
            const bool leaves = next[d] < 0 || next[d] >= nBoxes(d);
            next[d] = (next[d] + nBoxes(d)) % nBoxes(d);
            if (!leaves || cyclic_[d])
            {
                neighbour[2*d + side] = rank_[box(next)];
            }
        }
    }
    return blockLayout(n, start, pad_, neighbour);
}


Foam::fsi::blockPartition Foam::fsi::blockPartition::whole() const
{
    blockPartition one(*this);
    for (direction d = 0; d < 3; ++d)
    {
        one.cuts_[d] = labelList({0, n(d)});
    }
    one.rank_ = labelList(1, label(0));
    return one;
}


Foam::fsi::blockPartition Foam::fsi::blockPartition::slabs
(
    const direction d,
    const label nSlabs
) const
{
    blockPartition result(whole());
    const label nBoxes = min(nSlabs, n(d));
    result.pad_ = labelVector(0, 0, 0);
    result.rank_ = identityList(nBoxes);
    result.cuts_[d].setSize(nBoxes + 1);
    forAll(result.cuts_[d], i)
    {
        result.cuts_[d][i] = label(int64_t(n(d))*i/nBoxes);
    }
    return result;
}


Foam::fsi::blockPartition Foam::fsi::blockPartition::coarsened
(
    const labelVector& coarsen
) const
{
    blockPartition coarse(*this);
    for (direction d = 0; d < 3; ++d)
    {
        for (label i = 0; i < nBoxes(d) && coarsen[d]; ++i)
        {
            const label size = cuts_[d][i + 1] - cuts_[d][i];
            coarse.cuts_[d][i + 1] = coarse.cuts_[d][i] + (size + 1)/2;
        }
    }
    return coarse;
}


Foam::label Foam::fsi::blockPartition::owner(const labelVector& cell) const
{
    labelVector position;
    for (direction d = 0; d < 3; ++d)
    {
        const labelList& cuts = cuts_[d];
        position[d] = label
        (
            std::upper_bound(cuts.begin(), cuts.end(), cell[d])
          - cuts.begin()
        ) - 1;
    }
    return rank_[box(position)];
}


// ************************************************************************* //
