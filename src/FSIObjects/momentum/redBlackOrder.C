// SPDX-License-Identifier: GPL-3.0-or-later

#include "redBlackOrder.H"
#include "cyclicPolyPatch.H"
#include "openfoamMesh.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Is a cell red?
static boolList redCells(const cartesianMesh& grid)
{
    const cartesianBlock block(grid.cells());
    const labelList& blockIndex = grid.blockIndex();
    boolList red(blockIndex.size());
    forAll(red, celli)
    {
        const labelVector ijk(block.ijk(blockIndex[celli]) + block.start());
        red[celli] = (ijk.x() + ijk.y() + ijk.z()) % 2 == 0;
    }
    return red;
}


//- Cyclic patches whose cells have the colour of those on the other side
static boolList oddCyclics(const cartesianMesh& grid)
{
    const boolList red(redCells(grid));
    const polyBoundaryMesh& patches = grid.mesh().boundaryMesh();
    boolList odd(patches.size(), false);
    forAll(patches, patchi)
    {
        if (isA<cyclicPolyPatch>(patches[patchi]) && patches[patchi].size())
        {
            const cyclicPolyPatch& opposite =
                oppositeOf(refCast<const cyclicPolyPatch>(patches[patchi]));
            odd[patchi] =
                red[patches[patchi].faceCells()[0]]
             == red[opposite.faceCells()[0]];
        }
    }
    return odd;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::redBlackOrder::setRows()
{
    const cartesianBlock block(grid_.cells());
    const labelList& blockIndex = grid_.blockIndex();

    const boolList red(redCells(grid_));
    nRed_ = std::count(red.begin(), red.end(), true);

    // In the order of the block, so that neighbours are near in memory
    labelList order(block.size(), -1);
    forAll(blockIndex, celli)
    {
        order[blockIndex[celli]] = celli;
    }
    label nextRed = 0;
    label nextBlack = nRed_;
    rowOf_.setSize(red.size());
    for (const label celli : order)
    {
        if (celli >= 0)
        {
            rowOf_[celli] = red[celli] ? nextRed++ : nextBlack++;
        }
    }
}


Foam::label Foam::fsi::redBlackOrder::slot
(
    const label facei,
    const bool owner
) const
{
    const polyMesh& mesh = grid_.mesh();
    const label celli =
        owner ? mesh.faceOwner()[facei] : mesh.faceNeighbour()[facei];
    const bool above = grid_.faceAlong(facei) == owner;
    return nSlots_*rowOf_[celli] + 2*grid_.faceDirection(facei) + label(above);
}


void Foam::fsi::redBlackOrder::setPatchSlots
(
    const label patchi,
    labelList& neighbourRow
)
{
    const polyPatch& patch = grid_.mesh().boundaryMesh()[patchi];
    const labelUList& cells = patch.faceCells();
    const label firstGhost = ghosts_.start(patchi);
    patchSlot_[patchi].setSize(cells.size());
    forAll(cells, i)
    {
        const label row =
            firstGhost >= 0
          ? firstGhost + i
          : rowOf_
            [
                oppositeOf(refCast<const cyclicPolyPatch>(patch))
               .faceCells()[i]
            ];
        patchSlot_[patchi][i] = slot(patch.start() + i, true);
        neighbourRow[patchSlot_[patchi][i]] = row;
    }
}


Foam::labelList Foam::fsi::redBlackOrder::setSlots()
{
    const fvMesh& mesh = grid_.mesh();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();

    labelList neighbourRow(nSlots_*mesh.nCells(), -1);
    ownerSlot_.setSize(own.size());
    neighbourSlot_.setSize(own.size());
    forAll(own, facei)
    {
        ownerSlot_[facei] = slot(facei, true);
        neighbourSlot_[facei] = slot(facei, false);
        neighbourRow[ownerSlot_[facei]] = rowOf_[nei[facei]];
        neighbourRow[neighbourSlot_[facei]] = rowOf_[own[facei]];
    }

    patchSlot_.setSize(mesh.boundary().size());
    forAll(patchSlot_, patchi)
    {
        if (mesh.boundaryMesh()[patchi].coupled())
        {
            setPatchSlots(patchi, neighbourRow);
        }
    }
    return neighbourRow;
}


Foam::FixedList<Foam::label, 6> Foam::fsi::redBlackOrder::offsets
(
    const labelUList& neighbourRow,
    const label row
) const
{
    const label* neighbour = neighbourRow.cdata() + nSlots_*row;
    const label* some =
        std::find_if
        (
            neighbour, neighbour + nSlots_, [](label other){return other >= 0;}
        );
    const label instead = some < neighbour + nSlots_ ? *some - row : 0;
    FixedList<label, 6> offset(Zero);
    for (label k = 0; k < nSlots_; ++k)
    {
        offset[k] = neighbour[k] >= 0 ? neighbour[k] - row : instead;
    }
    return offset;
}


void Foam::fsi::redBlackOrder::setRuns(const labelUList& neighbourRow)
{
    forAll(rowOf_, row)
    {
        const FixedList<label, 6> offset(offsets(neighbourRow, row));
        if (row == 0 || row == nRed_ || runs_.last().offset != offset)
        {
            runs_.append(redBlackRun{row, row, offset});
        }
        runs_.last().last = row + 1;
        if (row < nRed_)
        {
            nRedRuns_ = runs_.size();
        }
    }
    runs_.shrink();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::redBlackOrder::redBlackOrder(const cartesianMesh& grid)
:
    grid_(grid),
    nSlots_(2*grid.nDims()),
    nRed_(0),
    ghosts_(grid.mesh(), oddCyclics(grid)),
    nRedRuns_(0)
{
    setRows();
    setRuns(setSlots());
}


// ************************************************************************* //
