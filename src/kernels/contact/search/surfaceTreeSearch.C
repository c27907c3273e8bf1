// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceTreeSearch.H"
#include "addToRunTimeSelectionTable.H"
#include "openfoamVersion.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(surfaceTreeSearch, 0);
    addToRunTimeSelectionTable(contactSearch, surfaceTreeSearch, dictionary);

    //- Square of the distance of two boxes, or of a box and a point
    static scalar distanceSqr
    (
        const boundBox& a,
        const point& lower,
        const point& upper
    )
    {
        const vector apart(max(lower - a.max(), a.min() - upper));
        return magSqr(max(apart, vector::zero));
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceTreeSearch::surfaceTreeSearch(const dictionary& dict)
:
    contactSearch(dict)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceTreeSearch::findNear
(
    const surfaceSet& surfaces,
    const scalar range
)
{
    const auto left = [&](const label objecti)
    {
        return trees_.root(objecti).places.min().x();
    };
    sweep_.clear();
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (surfaces.hasWalls(objecti))
        {
            sweep_.append(objecti);
        }
    }
    std::sort
    (
        sweep_.begin(), sweep_.end(),
        [&](const label a, const label b) { return left(a) < left(b); }
    );

    near_.clear();
    forAll(sweep_, i)
    {
        const label a = sweep_[i];
        const boundBox& box = trees_.root(a).places;
        if (geometry_.selfContact())
        {
            near_.append(labelPair(a, a));
        }
        for (label j = i + 1; j < sweep_.size(); ++j)
        {
            const label b = sweep_[j];
            const boundBox& other = trees_.root(b).places;
            if (left(b) > box.max().x() + range)
            {
                break;
            }
            if
            (
                distanceSqr(box, other.min(), other.max())
             <= sqr(reach(a, b, range))
            )
            {
                near_.append(labelPair(a, b));
                near_.append(labelPair(b, a));
            }
        }
    }
    std::sort(near_.begin(), near_.end());
}


void Foam::fsi::surfaceTreeSearch::descend
(
    const nodeGroup& nodes,
    const label objecti,
    const scalar range
)
{
    const surfaceTrees::branch* tree = trees_.tree(objecti);
    const label nGroups = trees_.order(objecti).nGroups();
    visit_.clear();
    visit_.append(1);
    while (visit_.size())
    {
        const label i = visit_.remove();
        const surfaceTrees::branch& b = tree[i];
        const bool own = geometry_.selfContact();
        if (!nodes.mayPair(objecti, b.places, b.normals, range, own))
        {
            continue;
        }
        if (i >= nGroups)
        {
            candidates_.append(candidate{objecti, i - nGroups, 0});
        }
        else
        {
            visit_.append(2*i);
            visit_.append(2*i + 1);
        }
    }
}


void Foam::fsi::surfaceTreeSearch::visit
(
    const surfaceSet& surfaces,
    const label nodei,
    const scalar range
)
{
    const point& x = surfaces.points()[nodei];
    const label objecti = surfaces.pointObject()[nodei];
    for (candidate& c : candidates_)
    {
        const label leaf = trees_.order(c.object).nGroups() + c.group;
        c.distanceSqr = distanceSqr(trees_.tree(c.object)[leaf].places, x, x);
    }
    std::sort
    (
        candidates_.begin(),
        candidates_.end(),
        [](const candidate& a, const candidate& b)
        {
            return a.distanceSqr < b.distanceSqr;
        }
    );
    for (const candidate& c : candidates_)
    {
        // As far as what was found: an edge's other face may be in this group
        const scalar limit = reach(objecti, c.object, range);
        const auto farthest = [&]()
        {
            return
                1.000001
               *Foam::sqrt(geometry_.reachSqr(surfaces, c.object, limit));
        };
        scalar nearest = farthest();
        if (c.distanceSqr > sqr(nearest))
        {
            continue;
        }
        const label start = surfaces.faceStart()[c.object];
        for (const label local : trees_.order(c.object).faces(c.group))
        {
            const label facei = start + local;
            const surfaceTrees::sphere& s = trees_.around(facei);
            if (magSqr(x - s.centre) <= sqr(nearest + s.radius))
            {
                geometry_.consider(surfaces, nodei, facei, limit);
                nearest = farthest();
            }
        }
    }
}


void Foam::fsi::surfaceTreeSearch::findPairs
(
    const surfaceSet& surfaces,
    const label objecti,
    const UList<labelPair>& near,
    const scalar range,
    contactPairs& found
)
{
    const faceOrder& order = trees_.order(objecti);
    const label start = surfaces.pointStart()[objecti];
    const label first = found.pairs.size();
    for (label group = 0; group < order.nGroups(); ++group)
    {
        const UList<label> nodes(order.nodes(group));
        if (nodes.empty())
        {
            continue;
        }
        nodeGroup together(objecti);
        for (const label nodei : nodes)
        {
            geometry_.addTo(together, surfaces, start + nodei);
        }
        candidates_.clear();
        for (const labelPair& other : near)
        {
            const label otheri = other.second();
            descend(together, otheri, reach(objecti, otheri, range));
        }
        for (const label nodei : nodes)
        {
            visit(surfaces, start + nodei, range);
            geometry_.append(surfaces, start + nodei, found.pairs);
        }
    }
    std::stable_sort
    (
        found.pairs.begin() + first,
        found.pairs.end(),
        [](const contactPair& a, const contactPair& b)
        {
            return a.node < b.node;
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::surfaceTreeSearch::find
(
    const surfaceSet& surfaces,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>&,
    const scalar range,
    contactPairs& found
)
{
    found.clear();
    geometry_.update(surfaces);
    trees_.update(surfaces, geometry_);
    findNear(surfaces, range);

    label begin = 0;
    for (label objecti = 0; objecti < surfaces.nOriginals(); ++objecti)
    {
        if (!surfaces.hasWalls(objecti))
        {
            continue;
        }
        label end = begin;
        while (end < near_.size() && near_[end].first() == objecti)
        {
            ++end;
        }
        const SubList<labelPair> near(near_, end - begin, begin);
        begin = end;
        findPairs(surfaces, objecti, near, range, found);

        geometry_.appendRims(surfaces, objecti, walls, range, found.pairs);
        const label endNode = surfaces.pointStart()[objecti + 1];
        for (label i = surfaces.pointStart()[objecti]; i < endNode; ++i)
        {
            contactGeometry::appendWalls
            (
                surfaces.points()[i], i, walls, range, found.pairs
            );
        }
    }
}


// ************************************************************************* //
