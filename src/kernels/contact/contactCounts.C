// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactCounts.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Part of a range that ranks do not agree about
constexpr Foam::scalar roundOff = 1e-6;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::contactCounts::here
(
    const contactBodies& bodies,
    const labelPair& touch
)
{
    const label a = touch.first(), b = touch.second();
    if (a < 0 || bodies.pushedElsewhere(a) == bodies.pushedElsewhere(b))
    {
        return true;
    }
    return
        bodies[a].prescribed || bodies[b].prescribed
     || !bodies.pushedElsewhere(bodies[a].id < bodies[b].id ? a : b);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactCounts::count
(
    const contactProblem& problem,
    const bool limited,
    contactStatistics& statistics
)
{
    const surfaceSet& surfaces = problem.surfaces;
    statistics.contacts = 0;
    statistics.smallestGap = GREAT;
    statistics.sweeps = 0;
    statistics.objectContacts.setSize(surfaces.size());
    statistics.objectContacts = 0;
    statistics.objectGaps.setSize(surfaces.size());
    statistics.objectGaps = GREAT;
    touching_.clear();

    for (const contactPair& pair : problem.found.pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        scalar& ownGap = statistics.objectGaps[own];
        ownGap = min(ownGap, pair.gap);
        if (pair.other >= 0)
        {
            scalar& otherGap = statistics.objectGaps[pair.other];
            otherGap = min(otherGap, pair.gap);
        }
        statistics.smallestGap = min(statistics.smallestGap, pair.gap);

        const scalar range =
            limited && pair.other != own
          ? problem.range/pair.stretch
          : problem.range;
        // A range that follows its gap is equal to it but for round-off
        if (pair.gap < (1 - roundOff)*range)
        {
            touching_.append
            (
                labelPair(min(own, pair.other), max(own, pair.other))
            );
        }
    }

    std::sort(touching_.begin(), touching_.end());
    const auto end = std::unique(touching_.begin(), touching_.end());
    for (auto touch = touching_.begin(); touch != end; ++touch)
    {
        statistics.contacts += here(problem.bodies, *touch);
        ++statistics.objectContacts[touch->second()];
        if (touch->first() >= 0)
        {
            ++statistics.objectContacts[touch->first()];
        }
    }
}


const Foam::fsi::contactPairs& Foam::fsi::contactCounts::ownPairs
(
    const contactProblem& problem
)
{
    ownPairs_.clear();
    for (const contactPair& pair : problem.found.pairs)
    {
        const label own = problem.surfaces.pointObject()[pair.node];
        if (!problem.bodies.pushedElsewhere(own))
        {
            ownPairs_.pairs.append(pair);
        }
    }
    return ownPairs_;
}


// ************************************************************************* //
