// SPDX-License-Identifier: GPL-3.0-or-later

#include "partlyOpenFaces.H"
#include "fetchAhead.H"
#include "levelSetUpdate.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Share of a cell in what the pressure adds in a face's middle: half where
//  both or none are fluid, else all of the fluid one, (4.6)
scalar incrementShare(const bool fluid, const bool otherFluid)
{
    return fluid == otherFluid ? 0.5 : scalar(fluid);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::direction Foam::fsi::partlyOpenFaces::openDirection
(
    const scalarField& cornerDistance,
    const cartesianBlock& corners,
    const label facei,
    bool& rises
) const
{
    const FixedList<label, 4> around = grid_.cornersOf(facei);
    const label nCorners = grid_.nDims() == 2 ? 2 : 4;

    direction dir = 0;
    scalar largest = -1;
    for (label i = 1; i < nCorners; i += 2)
    {
        // From an edge to the opposite one
        scalar rise = cornerDistance[around[i]] - cornerDistance[around[0]];
        if (nCorners == 4)
        {
            rise +=
                cornerDistance[around[2]] - cornerDistance[around[4 - i]];
        }
        if (mag(rise) > largest)
        {
            const label way = around[i] - around[0];
            largest = mag(rise);
            dir =
                mag(way) == corners.stride(0) ? 0
              : mag(way) == corners.stride(1) ? 1 : 2;
            rises = (rise > 0) == (way > 0);
        }
    }
    return dir;
}


void Foam::fsi::partlyOpenFaces::add
(
    const scalarField& cornerDistance,
    const cartesianBlock& corners,
    const label walli,
    const wallFace& w
)
{
    const boolList& fluidCell = open_.fluidCell();
    const label nInternal = grid_.mesh().nInternalFaces();
    const scalar open = open_.openness()[w.face];
    const bool internal = w.face < nInternal;

    // Both cells of an open face are active; the lower number is the owner
    const label own = internal ? min(w.lower, w.upper) : max(w.lower, w.upper);
    const label nei = internal ? max(w.lower, w.upper) : -1;
    const bool fluid =
        internal ? fluidCell[nei] : open_.fluidAcross()[w.face - nInternal];
    bool rises = true;
    const direction dir =
        openDirection(cornerDistance, corners, w.face, rises);
    openFace o;
    o.wall = walli;
    o.face = w.face;
    o.dir = w.dir;
    o.middleClosed = open < 0.5;
    o.beyond = o.middleClosed ? open/(1 + 2*open) : 0.5*(1 - open);
    o.sides[0] = own;
    o.sides[1] = nei;
    o.cells[0] = grid_.nextCell(own, dir, rises);
    o.cells[1] = internal ? grid_.nextCell(nei, dir, rises) : o.cells[0];
    o.increments[0] = incrementShare(fluidCell[own], fluid);
    o.increments[1] = incrementShare(fluid, fluidCell[own]);
    if (o.cells[0] != -1 && o.cells[1] != -1)
    {
        faces_.append(o);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::partlyOpenFaces::partlyOpenFaces(const openParts& open)
:
    grid_(open.grid()),
    open_(open)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::partlyOpenFaces::update
(
    const levelSetUpdate& levelSet,
    const UList<wallFace>& wallFaces
)
{
    const label nInternal = grid_.mesh().nInternalFaces();
    const polyBoundaryMesh& patches = grid_.mesh().boundaryMesh();
    const scalarField& openness = open_.openness();
    const cartesianBlock corners(grid_.corners());
    faces_.clear();
    forAll(wallFaces, walli)
    {
        const wallFace& later = fetchedAhead(wallFaces, walli);
        fetchAhead(openness[later.face]);
        fetchAhead(grid_.faceCorners().first()[later.face]);

        const wallFace& w = wallFaces[walli];
        if
        (
            openness[w.face] > 0
         && !w.film
         && (
                w.face < nInternal
             || patches[patches.whichPatch(w.face)].coupled()
            )
        )
        {
            add(levelSet.cornerDistance(), corners, walli, w);
        }
    }
}


// ************************************************************************* //
