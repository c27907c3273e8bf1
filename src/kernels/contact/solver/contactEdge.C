// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactEdge.H"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

//- Colours that the edges of objects have
class takenColours
{
    std::vector<std::vector<bool>> taken_;

public:

    explicit takenColours(const label nObjects)
    :
        taken_(nObjects)
    {}

    const std::vector<bool>& of(const label objecti) const
    {
        return taken_[objecti];
    }

    bool isFree(const label objecti, const label colour) const
    {
        return
            objecti < 0
         || colour >= label(taken_[objecti].size())
         || !taken_[objecti][colour];
    }

    void take(const label objecti, const label colour)
    {
        if (objecti >= 0)
        {
            const label n = taken_[objecti].size();
            taken_[objecti].resize(max(n, colour + 1), false);
            taken_[objecti][colour] = true;
        }
    }

    //- Give an edge the first colour that is free at both objects
    void colour(contactEdge& edge)
    {
        edge.colour = 0;
        while
        (
            !isFree(edge.low, edge.colour)
         || !isFree(edge.high, edge.colour)
        )
        {
            ++edge.colour;
        }
        take(edge.low, edge.colour);
        take(edge.high, edge.colour);
    }
};

//- A number that looks random for each two ids (finaliser of splitmix64)
std::uint64_t hashOf(const label low, const label high)
{
    std::uint64_t x =
        (std::uint64_t(std::uint32_t(low)) << 32) | std::uint32_t(high);
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30))*0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27))*0x94d049bb133111ebu;
    return x ^ (x >> 31);
}


//- Id of an object, -1 for none
label idOf(const contactBodies& bodies, const label objecti)
{
    return objecti >= 0 ? bodies[objecti].id : -1;
}


//- The edges in the order of their priorities
std::vector<contactEdge*> byPriority
(
    const contactBodies& bodies,
    std::vector<contactEdge>& edges
)
{
    std::vector<std::pair<std::uint64_t, contactEdge*>> sorted;
    for (contactEdge& e : edges)
    {
        const std::uint64_t priority =
            hashOf(idOf(bodies, e.low), idOf(bodies, e.high));
        sorted.push_back({priority, &e});
    }
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b)
    {
        return a.first > b.first;
    });
    std::vector<contactEdge*> result;
    for (const auto& each : sorted)
    {
        result.push_back(each.second);
    }
    return result;
}


//- Find the same colours where several ranks have edges. An edge between
//  objects of two ranks gets its colour when all others at both objects whose
//  priority is higher have theirs
class sharedColours
{
    const contactBodies& bodies_;
    const contactExchange& exchange_;
    takenColours taken_;

    //- Own edges, and those between ranks in the order of their ids
    std::vector<contactEdge*> sorted_;
    std::map<labelPair, contactEdge*> shared_;

    //- Edges between ranks that are the first without a colour at the own
    //  object
    std::set<const contactEdge*> first_;

    bool isShared(const contactEdge& e) const
    {
        return e.low >= 0 && bodies_[e.low].guest != bodies_[e.high].guest;
    }

    label guest(const contactEdge& e) const
    {
        return bodies_[e.low].guest ? e.low : e.high;
    }

    label own(const contactEdge& e) const
    {
        return bodies_[e.low].guest ? e.high : e.low;
    }

    //- Colour what does not depend on other ranks; number of edges left
    label colourOwn()
    {
        label nLeft = 0;
        std::vector<bool> waits(bodies_.size(), false);
        first_.clear();
        for (contactEdge* e : sorted_)
        {
            if (e->colour >= 0)
            {
                continue;
            }
            const bool shared = isShared(*e);
            const label low = shared ? own(*e) : e->low;
            const label high = shared ? own(*e) : e->high;
            const bool next =
                (low < 0 || !waits[low]) && (high < 0 || !waits[high]);
            if (next && !shared)
            {
                taken_.colour(*e);
                continue;
            }
            if (next)
            {
                first_.insert(e);
            }
            for (const label objecti : {low, high})
            {
                if (objecti >= 0)
                {
                    waits[objecti] = true;
                }
            }
            ++nLeft;
        }
        return nLeft;
    }

    //- Colour edges that are the first ones at both objects
    void colourShared()
    {
        // Is it the first one here, and which colours are taken?
        List<DynamicList<scalar>> sent(exchange_.nRanks());
        for (const auto& each : shared_)
        {
            const contactEdge& e = *each.second;
            if (e.colour < 0)
            {
                DynamicList<scalar>& to = sent[exchange_.owner(guest(e))];
                const std::vector<bool>& taken = taken_.of(own(e));
                to.append(first_.count(&e));
                to.append(taken.size());
                for (const bool is : taken)
                {
                    to.append(is);
                }
            }
        }
        const List<scalarList> received(exchange_.swap(sent));
        labelList next(received.size(), Zero);
        for (const auto& each : shared_)
        {
            contactEdge& e = *each.second;
            if (e.colour >= 0)
            {
                continue;
            }
            const label ranki = exchange_.owner(guest(e));
            const scalar* theirs = received[ranki].cdata() + next[ranki];
            const label n = theirs[1];
            next[ranki] += n + 2;
            if (theirs[0] > 0 && first_.count(&e))
            {
                label colour = 0;
                while
                (
                    !taken_.isFree(own(e), colour)
                 || (colour < n && theirs[2 + colour] > 0)
                )
                {
                    ++colour;
                }
                e.colour = colour;
                taken_.take(own(e), colour);
            }
        }
    }

public:

    sharedColours
    (
        const contactBodies& bodies,
        const contactExchange& exchange,
        std::vector<contactEdge>& edges
    )
    :
        bodies_(bodies),
        exchange_(exchange),
        taken_(bodies.size()),
        sorted_(byPriority(bodies, edges))
    {
        for (contactEdge& e : edges)
        {
            e.colour = -1;
            if (isShared(e))
            {
                const labelPair ids(bodies[e.low].id, bodies[e.high].id);
                shared_[ids] = &e;
            }
        }
        while (exchange_.largest(colourOwn()) > 0)
        {
            colourShared();
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::setColours
(
    const contactBodies& bodies,
    const contactExchange* exchange,
    std::vector<contactEdge>& edges
)
{
    if (exchange)
    {
        sharedColours(bodies, *exchange, edges);
    }
    else
    {
        takenColours taken(bodies.size());
        for (contactEdge* edge : byPriority(bodies, edges))
        {
            taken.colour(*edge);
        }
    }
    label nColours = 0;
    for (const contactEdge& edge : edges)
    {
        nColours = max(nColours, edge.colour + 1);
    }
    return exchange ? label(exchange->largest(nColours)) : nColours;
}


// ************************************************************************* //
