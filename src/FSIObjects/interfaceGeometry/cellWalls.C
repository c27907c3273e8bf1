// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellWalls.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

//- Sides face the same way if the cosine between their normals is larger: not
//  where a right angle is on either side of the limit
const scalar leastCosine = -0.1;


//- Cell of a side, or -1
label sideCell(const UList<wallFace>& faces, const label side)
{
    const wallFace& w = faces[side/2];
    return side % 2 ? w.upper : w.lower;
}


//- Place of a side about its cell: z, y and x below, then x, y and z above. The
//  order of faces in the mesh is another one at patches, so between ranks
direction sidePlace(const UList<wallFace>& faces, const label side)
{
    const direction dir = faces[side/2].dir;
    return side % 2 ? 2 - dir : 3 + dir;
}


//- The sum of the area vectors of faces
vector areaNormal(const surfaceSet& surfaces, const UList<label>& faces)
{
    vector sum(Zero);
    for (const label facei : faces)
    {
        sum += surfaces.areaNormal(facei);
    }
    return sum;
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


void Foam::fsi::cellWalls::chainSides
(
    const surfaceSet& surfaces,
    const UList<wallFace>& faces,
    const UList<wallOrigin>& origins,
    const UList<label>& sides
)
{
    const auto object = [&](const label i)
    {
        return faces[sides[i]/2].place.object;
    };
    normals_.clear();
    chained_.clear();
    for (const label side : sides)
    {
        const wallFace& w = faces[side/2];
        there_.clear();
        appendFacesAt
        (
            surfaces, origins[side/2].surface, w.place.weights, there_
        );
        normals_.append(normalised(areaNormal(surfaces, there_)));
        chained_.append(chained_.empty());
    }
    for (bool grown = true; grown;)
    {
        grown = false;
        forAll(sides, i)
        {
            for (label j = 0; j < sides.size() && !chained_[i]; ++j)
            {
                chained_[i] =
                    chained_[j] && object(i) == object(j)
                 && (normals_[i] & normals_[j]) > leastCosine;
                grown = grown || chained_[i];
            }
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
    chainSides(surfaces, faces, origins, sides);
    near_.clear();
    cellWall wall{sideCell(faces, sides[0]), vector(Zero), surfacePlace()};
    point cuts(Zero), closed(Zero);
    scalar nCuts = 0, area = 0;
    label nOthers = 0;
    forAll(sides, i)
    {
        const label side = sides[i];
        const wallFace& w = faces[side/2];
        const wallOrigin& origin = origins[side/2];
        if (!chained_[i])
        {
            sides[nOthers++] = side;
            continue;
        }
        appendFacesAt(surfaces, origin.surface, w.place.weights, near_);
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
        near_,
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
        std::sort(sides.begin(), sides.end(), [&](label a, label b)
        {
            const direction placeA = sidePlace(faces, a);
            const direction placeB = sidePlace(faces, b);
            return placeA != placeB ? placeA < placeB : a < b;
        });
        while (sides.size())
        {
            addPart(surfaces, faces, origins, sides);
        }
    }
}


// ************************************************************************* //
