// SPDX-License-Identifier: GPL-3.0-or-later

#include "openParts.H"
#include "wallTreatment.H"
#include "levelSetUpdate.H"
#include "periodicImages.H"
#include "sumOverRanks.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A face whose cells are both farther from the surfaces, in cells, is open or
//  closed as a whole, and so are those next to it: less than the band's least
//  width
static const scalar nearest = 2.5;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::openParts::openPart
(
    const levelSetUpdate& levelSet,
    const label facei,
    const label here
) const
{
    const label nCorners = grid_.nDims() == 2 ? 2 : 4;
    const label across = here + grid_.stepAcross(facei);
    const scalar inCell = levelSet.cellDistance()[here];
    const scalar beyond = levelSet.cellDistance()[across];
    const FixedList<label, 4> corners = grid_.cornersOf(facei);
    FixedList<scalar, 4> distance(Zero);
    scalar lowest = min(inCell, beyond);
    scalar highest = max(inCell, beyond);
    for (label i = 0; i < nCorners; ++i)
    {
        distance[i] = levelSet.cornerDistance()[corners[i]];
        lowest = min(lowest, distance[i]);
        highest = max(highest, distance[i]);
    }
    if (lowest > 0 || highest <= 0)
    {
        // Most faces; no treatment would have it another way
        return lowest > 0 ? 1 : 0;
    }
    const scalar open = wall_.openness(distance, nCorners, inCell, beyond);
    return open < filmFaces::smallestOpenness ? 0 : open;
}


void Foam::fsi::openParts::setOpenness
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const fvMesh& mesh = grid_.mesh();
    const labelList& owner = mesh.faceOwner();
    const labelList& haloIndex = grid_.haloIndex();
    const scalarField& cellDistance = levelSet.cellDistance();
    const scalar reach = nearest*grid_.spacing();

    nearFaces_.clear();
    grid_.forFaces([&](const label facei)
    {
        const label here = haloIndex[owner[facei]];
        const scalar inCell = cellDistance[here];
        const scalar beyond = cellDistance[here + grid_.stepAcross(facei)];
        if (min(mag(inCell), mag(beyond)) > reach)
        {
            // All corners are on the same side
            openness_[facei] = inCell > 0 ? 1 : 0;
            return;
        }
        nearFaces_.append(facei);
        openness_[facei] = openPart(levelSet, facei, here);
    });

    films_.update(levelSet, surfaces, nearFaces_);
    for (const filmFace& film : films_.faces())
    {
        openness_[film.face] = film.open();
    }
    forAllConstIter(Map<wallOrigin>, films_.closed(), iter)
    {
        openness_[iter.key()] = 0;
    }

    // On cyclic patches the distances of both sides differ by round-off
    SubList<scalar> boundary
    (
        openness_,
        mesh.nFaces() - mesh.nInternalFaces(),
        mesh.nInternalFaces()
    );
    syncCoupledFaces(mesh, boundary, minEqOp<scalar>());
}


void Foam::fsi::openParts::setCells(const levelSetUpdate& levelSet)
{
    const polyMesh& mesh = grid_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const labelList& owner = mesh.faceOwner();
    const labelList& neighbour = mesh.faceNeighbour();
    const labelList& haloIndex = grid_.haloIndex();
    const scalarField& distance = levelSet.cellDistance();

    // More than a cell's diagonal from the surfaces all sides are open
    const scalar h = grid_.spacing();
    forAll(activeCell_, celli)
    {
        activeCell_[celli] = fluidCell_[celli] =
            distance[haloIndex[celli]] > h;
    }
    const auto activate = [&](const label celli)
    {
        if (!activeCell_[celli])
        {
            activeCell_[celli] = true;
            fluidCell_[celli] = distance[haloIndex[celli]] > 0;
        }
    };
    for (const label facei : nearFaces_)
    {
        if (openness_[facei] <= 0)
        {
            continue;
        }
        if (facei < neighbour.size())
        {
            activate(owner[facei]);
            activate(neighbour[facei]);
        }
        else if (patches[patches.whichPatch(facei)].coupled())
        {
            activate(owner[facei]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::openParts::openParts
(
    const cartesianMesh& grid,
    const wallTreatment& wall
)
:
    grid_(grid),
    wall_(wall),
    openness_(grid.mesh().nFaces(), 1),
    known_(false),
    first_(true),
    hasWalls_(false),
    fluidCell_(grid.mesh().nCells(), true),
    activeCell_(grid.mesh().nCells(), true),
    films_(grid, wall)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::openParts::update
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces
)
{
    const bool hadWalls = hasWalls_;
    first_ = !known_;
    known_ = true;
    hasWalls_ = overRanks(periodicImages::anyWalls(surfaces), orOp<bool>());
    if (!first_ && !hadWalls && !hasWalls_)
    {
        lastOpenness_.clear();
        return false;
    }
    if (!first_)
    {
        lastOpenness_.setSize(openness_.size());
        lastOpenness_.swap(openness_);
    }
    setOpenness(levelSet, surfaces);
    setCells(levelSet);
    swapCoupledCells(grid_.mesh(), fluidCell_, fluidAcross_);
    return true;
}


// ************************************************************************* //
