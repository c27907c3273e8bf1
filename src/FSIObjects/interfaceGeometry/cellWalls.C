// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellWalls.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

//- Cell of a side, or -1
label sideCell(const UList<wallFace>& faces, const label side)
{
    const wallFace& w = faces[side/2];
    return side % 2 ? w.upper : w.lower;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cellWalls::setSides(const UList<wallFace>& faces)
{
    firstSide_ = -1;
    nextSide_.setSize(2*faces.size());
    forAllReverse(nextSide_, side)
    {
        const label celli = sideCell(faces, side);
        if (celli >= 0)
        {
            nextSide_[side] = firstSide_[celli];
            firstSide_[celli] = side;
        }
    }
}


void Foam::fsi::cellWalls::addPart
(
    const surfaceSet& surfaces,
    const UList<wallFace>& faces,
    const UList<wallOrigin>& origins,
    DynamicList<label>& sides
)
{
    const label first = sides[0];
    const label object = faces[first/2].place.object;
    const vector normal(surfaces.areaNormal(origins[first/2].surface));
    cellWall wall{sideCell(faces, first), vector(Zero), surfacePlace()};
    point cuts(Zero), closed(Zero);
    scalar nCuts = 0, area = 0;
    FixedList<label, 6> near;
    label nNear = 0, nOthers = 0;
    for (const label side : sides)
    {
        const wallFace& w = faces[side/2];
        const wallOrigin& origin = origins[side/2];
        if
        (
            w.place.object != object
         || (surfaces.areaNormal(origin.surface) & normal) <= 0
        )
        {
            sides[nOthers++] = side;
            continue;
        }
        near[nNear++] = origin.surface;
        wall.area[w.dir] += side % 2 ? -w.area : w.area;
        closed += w.area*origin.middle;
        area += w.area;
        if (origin.cut)
        {
            cuts += origin.middle;
            nCuts += 1;
        }
    }
    sides.setSize(nOthers);

    label found;
    wall.place = nearestPlace
    (
        surfaces,
        nCuts > 0 ? point(cuts/nCuts) : point(closed/area),
        UList<label>(near.data(), nNear),
        found
    );
    parts_.append(wall);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cellWalls::update
(
    const surfaceSet& surfaces,
    const UList<wallFace>& faces,
    const UList<wallOrigin>& origins
)
{
    setSides(faces);
    parts_.clear();
    DynamicList<label> sides;
    for (const label first : firstSide_)
    {
        for (label side = first; side >= 0; side = nextSide_[side])
        {
            sides.append(side);
        }
        while (sides.size())
        {
            addPart(surfaces, faces, origins, sides);
        }
    }
}


// ************************************************************************* //
