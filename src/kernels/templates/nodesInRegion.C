// SPDX-License-Identifier: GPL-3.0-or-later

#include "nodesInRegion.H"
#include "DynamicList.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamTypes.H"
#include "openfoamVersion.H"
#include "readBetween.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef std::function<bool(const point&)> region;

//- A vector without what does not matter in two dimensions
static vector inPlane(vector v, const direction nDims)
{
    v.z() = nDims == 2 ? 0 : v.z();
    return v;
}


//- The region around the point that is nearest to a place
static region nearestTo
(
    const point& place,
    const UList<point>& points,
    const direction nDims
)
{
    scalar least = GREAT;
    for (const point& p : points)
    {
        least = min(least, mag(inPlane(p - place, nDims)));
    }
    return [=](const point& p)
    {
        return mag(inPlane(p - place, nDims)) <= least;
    };
}


//- The region that a dictionary describes
static region readRegion
(
    const dictionary& dict,
    const UList<point>& points,
    const direction nDims,
    const wordList& further
)
{
    const word type(readChoice
    (
        dict, "type", "", {"box", "sphere", "halfSpace", "nearest"}
    ));
    wordList keys({"type"});
    keys.append(further);
    const auto flat = [&](const vector& v) { return inPlane(v, nDims); };
    region inside;
    if (type == "box")
    {
        keys.append(wordList({"min", "max"}));
        const vector least(flat(readFinite(dict, "min")));
        const vector most(flat(readFinite(dict, "max")));
        inside = [=](const point& p)
        {
            return
                cmptMin(inPlane(p - least, nDims)) >= 0
             && cmptMin(inPlane(most - p, nDims)) >= 0;
        };
    }
    else if (type == "sphere")
    {
        keys.append(wordList({"centre", "radius"}));
        const vector centre(flat(readFinite(dict, "centre")));
        const scalar radius = readPositive(dict, "radius");
        inside = [=](const point& p)
        {
            return mag(inPlane(p - centre, nDims)) <= radius;
        };
    }
    else if (type == "halfSpace")
    {
        keys.append(wordList({"point", "normal"}));
        const vector place(flat(readFinite(dict, "point", Zero)));
        const vector normal(flat(readFinite(dict, "normal")));
        if (mag(normal) == 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'normal' in dictionary " << dict.name()
                << " must not be zero" << exit(FatalIOError);
        }
        inside = [=](const point& p) { return ((p - place) & normal) >= 0; };
    }
    else
    {
        keys.append("point");
        inside = nearestTo
        (
            flat(readFinite(dict, "point", Zero)), points, nDims
        );
    }
    checkKeys(dict, keys);
    return inside;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsi::inShape
(
    const UList<point>& points,
    const point& origin
)
{
    pointField places(points.size());
    forAll(places, nodei)
    {
        places[nodei] = points[nodei] + origin;
    }
    return places;
}


Foam::labelList Foam::fsi::nodesInRegion
(
    const dictionary& dict,
    const UList<point>& points,
    const direction nDims,
    const wordList& further
)
{
    const region inside(readRegion(dict, points, nDims, further));
    const bool one = getEntry<word>(dict, "type") == "nearest";
    DynamicList<label> nodes;
    forAll(points, nodei)
    {
        if (inside(points[nodei]) && !(one && nodes.size()))
        {
            nodes.append(nodei);
        }
    }
    if (nodes.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The region of dictionary " << dict.name() << " has no node of"
            << " the shape, whose coordinates are " << min(points) << " to "
            << max(points) << exit(FatalIOError);
    }
    return labelList(nodes);
}


// ************************************************************************* //
