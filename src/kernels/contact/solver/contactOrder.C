// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactOrder.H"
#include <algorithm>

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

} // End anonymous namespace

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


} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactOrder::set
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactPair>& pairs,
    const contactExchange* exchange
)
{
    const std::vector<visit> visits(sortedVisits(surfaces, bodies, pairs));
    edges_.clear();
    for (label i = 0; i < label(visits.size()); ++i)
    {
        if (i == 0 || !visits[i].sameEdge(visits[i - 1]))
        {
            edges_.push_back({i, i, visits[i].low, visits[i].high, 0});
        }
        edges_.back().end = i + 1;
    }
    const label nColours = setColours(bodies, exchange, edges_);

    // Edges of a colour in the order in which their objects are stored
    std::stable_sort
    (
        edges_.begin(),
        edges_.end(),
        [](const edge& a, const edge& b) { return a.colour < b.colour; }
    );
    pairs_.clear();
    starts_.clear();
    for (edge& e : edges_)
    {
        while (starts_.size() <= e.colour)
        {
            starts_.append(pairs_.size());
        }
        const label first = pairs_.size();
        for (label i = e.first; i < e.end; ++i)
        {
            pairs_.append(visits[i].pairi);
        }
        e.first = first;
        e.end = pairs_.size();
    }
    while (starts_.size() <= nColours)
    {
        starts_.append(pairs_.size());
    }
}


// ************************************************************************* //
