// SPDX-License-Identifier: GPL-3.0-or-later

#include "heldNodes.H"
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
    const direction nDims
)
{
    const word type(readChoice
    (
        dict, "type", "", {"box", "sphere", "halfSpace", "nearest"}
    ));
    wordList keys({"type", "stiffness"});
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


//- Labels of the points in a region, of type nearest the first one
static labelList nodesIn
(
    const dictionary& dict,
    const UList<point>& points,
    const direction nDims
)
{
    const region inside(readRegion(dict, points, nDims));
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

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::heldNodes::heldNodes
(
    const dictionary& dict,
    const UList<point>& points,
    const point& origin,
    const direction nDims
)
{
    pointField places(points.size());
    forAll(places, nodei)
    {
        places[nodei] = points[nodei] + origin;
    }
    scalarField springs(points.size(), -1);
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' in dictionary "
                << dict.name() << " must be the dictionary of a region"
                << exit(FatalIOError);
        }
        const labelList nodes(nodesIn(e.dict(), places, nDims));
        const scalar spring =
            e.dict().found("stiffness")
          ? readPositive(e.dict(), "stiffness")/nodes.size()
          : 0;
        for (const label nodei : nodes)
        {
            if (springs[nodei] >= 0)
            {
                FatalIOErrorInFunction(e.dict())
                    << "The region of dictionary " << e.dict().name()
                    << " has the node at " << places[nodei]
                    << ", which another region of dictionary " << dict.name()
                    << " holds as well" << exit(FatalIOError);
            }
            springs[nodei] = spring;
        }
    }
    DynamicList<label> nodes;
    DynamicList<scalar> stiffness;
    forAll(springs, nodei)
    {
        if (springs[nodei] >= 0)
        {
            nodes.append(nodei);
            stiffness.append(springs[nodei]);
        }
    }
    nodes_ = nodes;
    stiffness_ = stiffness;
}


Foam::fsi::heldNodes::heldNodes
(
    const dictionary& written,
    const label nNodes
)
{
    if (!written.found("heldNodes"))
    {
        return;
    }
    nodes_ = readEntry<labelList>(written, "heldNodes");
    stiffness_ = readEntry<scalarField>(written, "heldStiffness");
    if
    (
        nodes_.empty() || min(nodes_) < 0 || max(nodes_) >= nNodes
     || stiffness_.size() != nodes_.size() || !(min(stiffness_) >= 0)
    )
    {
        FatalIOErrorInFunction(written)
            << "Entries 'heldNodes' and 'heldStiffness' in dictionary "
            << written.name() << " must be labels of the " << nNodes
            << " nodes, and as many springs >= 0" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fsi::heldNodes::clamped() const
{
    DynamicList<label> found;
    forAll(nodes_, i)
    {
        if (stiffness_[i] == 0)
        {
            found.append(nodes_[i]);
        }
    }
    return labelList(found);
}


Foam::scalarField Foam::fsi::heldNodes::masses
(
    const scalar dt,
    const scalar clampedMass
) const
{
    scalarField added(sqr(dt)*stiffness_);
    forAll(added, i)
    {
        added[i] = stiffness_[i] == 0 ? clampedMass : added[i];
    }
    return added;
}


void Foam::fsi::heldNodes::write(Ostream& os) const
{
    if (!empty())
    {
        putList(os, "heldNodes", nodes_);
        putList(os, "heldStiffness", stiffness_);
    }
}


// ************************************************************************* //
