// SPDX-License-Identifier: GPL-3.0-or-later

#include "interfaceGeometry.H"
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

Foam::direction Foam::fsi::interfaceGeometry::openDirection
(
    const scalarField& cornerDistance,
    const cartesianBlock& corners,
    const label facei,
    bool& rises
) const
{
    const FixedList<label, 4>& around = grid_.faceCorners(facei);
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
            const labelVector way
            (
                corners.ijk(around[i]) - corners.ijk(around[0])
            );
            largest = mag(rise);
            dir = way.x() ? 0 : way.y() ? 1 : 2;
            rises = (rise > 0) == (way[dir] > 0);
        }
    }
    return dir;
}


void Foam::fsi::interfaceGeometry::setOpenFaces
(
    const levelSetUpdate& levelSet,
    const boolList& across
)
{
    const fvMesh& mesh = grid_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const cartesianBlock corners(grid_.corners());
    openFaces_.clear();
    forAll(wallFaces_, walli)
    {
        const label facei = wallFaces_[walli].face;
        const scalar open = openness_[facei];
        const bool internal = facei < mesh.nInternalFaces();
        if
        (
            open <= 0
         || !(internal || patches[patches.whichPatch(facei)].coupled())
        )
        {
            continue;
        }
        bool rises = true;
        const direction dir =
            openDirection(levelSet.cornerDistance(), corners, facei, rises);
        const label own = mesh.faceOwner()[facei];
        const label nei = internal ? mesh.faceNeighbour()[facei] : own;
        const bool fluid =
            internal
          ? fluidCell_[nei]
          : across[facei - mesh.nInternalFaces()];
        openFace o;
        o.wall = walli;
        o.middleClosed = open < 0.5;
        o.beyond = o.middleClosed ? open/(1 + 2*open) : 0.5*(1 - open);
        o.cells[0] = grid_.nextCell(own, dir, rises);
        o.cells[1] =
            internal ? grid_.nextCell(nei, dir, rises) : o.cells[0];
        o.increments[0] = incrementShare(fluidCell_[own], fluid);
        o.increments[1] = incrementShare(fluid, fluidCell_[own]);
        if (o.cells[0] != -1 && o.cells[1] != -1)
        {
            openFaces_.append(o);
        }
    }
}


// ************************************************************************* //
