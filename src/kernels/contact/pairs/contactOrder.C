// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactOrder.H"
#include <algorithm>
#include <cstdint>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

//- A pair and the edge that it belongs to
struct visit
{
    //- The edge's objects, the one with the lower id first; -1: not pushed
    label low;
    label high;

    //- Is the node on the object with the higher id?
    bool nodeIsHigh;

    //- Id of the side that is not pushed, < 0: a wall
    label fixed;

    label pairi;

    bool sameEdge(const visit& v) const
    {
        return low == v.low && high == v.high;
    }

    bool operator<(const visit& v) const
    {
        return
            low != v.low ? low < v.low
          : high != v.high ? high < v.high
          : nodeIsHigh != v.nodeIsHigh ? v.nodeIsHigh
          : fixed != v.fixed ? fixed < v.fixed
          : pairi < v.pairi;
    }
};


//- An edge: its range in the sorted visits
struct edgeOfPairs
{
    label first;
    label end;
    std::uint64_t priority;
    label colour;
};

} // End anonymous namespace


//- A number that looks random for each two ids (finaliser of splitmix64)
static std::uint64_t hashOf(const label low, const label high)
{
    std::uint64_t x =
        (std::uint64_t(std::uint32_t(low)) << 32) | std::uint32_t(high);
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30))*0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27))*0x94d049bb133111ebu;
    return x ^ (x >> 31);
}


//- Id of an object, -1 for none
static label idOf(const contactBodies& bodies, const label objecti)
{
    return objecti >= 0 ? bodies[objecti].id : -1;
}


//- A pair as a part of its edge
static visit visitOf
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const contactPair& pair,
    const label pairi
)
{
    const label own = surfaces.pointObject()[pair.node];
    const label other = pair.other;
    const label ownId = bodies[own].id;
    const label otherId = other >= 0 ? bodies[other].id : other;
    if (other < 0 || !bodies.responds(other))
    {
        return {-1, bodies.responds(own) ? own : -1, true, otherId, pairi};
    }
    if (!bodies.responds(own))
    {
        return {-1, other, false, ownId, pairi};
    }
    return
        ownId > otherId
      ? visit{other, own, true, 0, pairi}
      : visit{own, other, false, 0, pairi};
}


//- The pairs, those of an edge side by side
static std::vector<visit> sortedVisits
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactPair>& pairs
)
{
    std::vector<visit> visits(pairs.size());
    forAll(pairs, pairi)
    {
        visits[pairi] = visitOf(surfaces, bodies, pairs[pairi], pairi);
    }
    std::sort(visits.begin(), visits.end());
    return visits;
}


//- The edges in the order of their priorities
static std::vector<edgeOfPairs> edgesOf
(
    const std::vector<visit>& visits,
    const contactBodies& bodies
)
{
    std::vector<edgeOfPairs> edges;
    for (label i = 0; i < label(visits.size()); ++i)
    {
        const visit& v = visits[i];
        if (i == 0 || !v.sameEdge(visits[i - 1]))
        {
            edges.push_back
            ({
                i, i, hashOf(idOf(bodies, v.low), idOf(bodies, v.high)), 0
            });
        }
        edges.back().end = i + 1;
    }
    std::sort
    (
        edges.begin(),
        edges.end(),
        [](const edgeOfPairs& a, const edgeOfPairs& b)
        {
            return a.priority > b.priority;
        }
    );
    return edges;
}


//- Give each edge the first colour that is free at both objects
static void setColours
(
    const std::vector<visit>& visits,
    const label nObjects,
    std::vector<edgeOfPairs>& edges
)
{
    std::vector<std::vector<bool>> taken(nObjects);
    const auto isFree = [&](const label objecti, const label colour)
    {
        return
            objecti < 0
         || colour >= label(taken[objecti].size())
         || !taken[objecti][colour];
    };
    for (edgeOfPairs& edge : edges)
    {
        const visit& v = visits[edge.first];
        while (!isFree(v.low, edge.colour) || !isFree(v.high, edge.colour))
        {
            ++edge.colour;
        }
        for (const label objecti : {v.low, v.high})
        {
            if (objecti >= 0)
            {
                const label n = taken[objecti].size();
                taken[objecti].resize(max(n, edge.colour + 1), false);
                taken[objecti][edge.colour] = true;
            }
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactOrder::set
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactPair>& pairs
)
{
    const std::vector<visit> visits(sortedVisits(surfaces, bodies, pairs));
    std::vector<edgeOfPairs> edges(edgesOf(visits, bodies));
    setColours(visits, bodies.size(), edges);

    // Edges of a colour in the order in which their objects are stored
    std::sort
    (
        edges.begin(),
        edges.end(),
        [](const edgeOfPairs& a, const edgeOfPairs& b)
        {
            return
                a.colour != b.colour
              ? a.colour < b.colour
              : a.first < b.first;
        }
    );
    pairs_.clear();
    starts_.clear();
    for (const edgeOfPairs& edge : edges)
    {
        if (edge.colour == starts_.size())
        {
            starts_.append(pairs_.size());
        }
        for (label i = edge.first; i < edge.end; ++i)
        {
            pairs_.append(visits[i].pairi);
        }
    }
}


// ************************************************************************* //
