// SPDX-License-Identifier: GPL-3.0-or-later

#include "contact.H"
#include "dictionaryCheck.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

//- Rule of limit(): a gap does not shrink below the minimum, or below what it
//  was if that was less. Never accelerates a pair apart
class minimumGapRule
:
    public contactRule
{
    const scalar minimum_;

public:

    explicit minimumGapRule(const scalar minimum)
    :
        minimum_(minimum)
    {}

    virtual scalar impulse
    (
        const scalar,
        const scalar gap,
        const scalar u,
        const scalar compliance,
        const scalar dt
    ) const
    {
        return max(min((minimum_ - gap)/dt, 0.0) - u, 0.0)/compliance;
    }
};

} // End anonymous namespace


//- Read the ranges and check the entries
static contactScales readScales
(
    const dictionary& dict,
    const scalar spacing,
    const scalar youngsModulus
)
{
    checkKeys(dict, {"range", "margin", "minimumGap", "search", "law"});
    return {spacing, readPositive(dict, "range", 3)*spacing, youngsModulus};
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contact::contact
(
    const dictionary& dict,
    const direction nDims,
    const scalar spacing,
    const scalar youngsModulus,
    const periodicImages& images
)
:
    scales_(readScales(dict, spacing, youngsModulus)),
    margin_(readNonNegative(dict, "margin", 1)*spacing),
    minimumGap_(readPositive(dict, "minimumGap", 0.1)*spacing),
    search_(contactSearch::New(dict.subOrEmptyDict("search"))),
    law_(contactLaw::New(dict.subOrEmptyDict("law"), scales_)),
    images_(images),
    limiter_(dictionary()),
    limitSearch_(contactSearch::New(dictionary())),
    moved_(nDims)
{
    if (images_.cyclic() && (needsMedialAxis() || needsInternalForces()))
    {
        FatalIOErrorInFunction(dict)
            << "Search 'medialAxis' and law 'thesis' in dictionary "
            << dict.name() << " do not see through cyclic patches;"
            << " valid searches and laws are all others"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contact::find
(
    contactSearch& search,
    const surfaceSet& surfaces,
    const UList<contactWall>& walls,
    const UList<contactMedialPoint>& medialAxis,
    const scalar range,
    contactPairs& found
)
{
    const surfaceSet& all = images_.update(surfaces, range);
    search.find(all, walls, medialAxis, range, found);
    if (all.nOriginals() == all.size())
    {
        return;
    }

    // What images' nodes find their originals find with other images
    label n = 0;
    for (const contactPair& pair : found.pairs)
    {
        if (all.originalNode(pair.node) == pair.node)
        {
            contactPair& kept = found.pairs[n++];
            kept = pair;
            if (pair.face >= 0)
            {
                kept.other = all.original(pair.other);
                kept.face = all.originalFace(pair.face);
            }
        }
    }
    found.pairs.resize(n);
}


void Foam::fsi::contact::count(const surfaceSet& surfaces)
{
    statistics_.contacts = 0;
    statistics_.smallestGap = GREAT;
    statistics_.potentialEnergy = 0;
    statistics_.sweeps = 0;
    statistics_.objectContacts.setSize(surfaces.size());
    statistics_.objectContacts = 0;
    statistics_.objectGaps.setSize(surfaces.size());
    statistics_.objectGaps = GREAT;
    touching_.clear();

    for (const contactPair& pair : found_.pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        scalar& ownGap = statistics_.objectGaps[own];
        ownGap = min(ownGap, pair.gap);
        if (pair.other >= 0)
        {
            scalar& otherGap = statistics_.objectGaps[pair.other];
            otherGap = min(otherGap, pair.gap);
        }
        statistics_.smallestGap = min(statistics_.smallestGap, pair.gap);
        if (pair.gap < scales_.range)
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
        ++statistics_.contacts;
        ++statistics_.objectContacts[touch->second()];
        if (touch->first() >= 0)
        {
            ++statistics_.objectContacts[touch->first()];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::fsi::contactStatistics& Foam::fsi::contact::calculate
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<contactMedialPoint>& medialAxis,
    const scalar dt,
    vectorField& force
)
{
    find
    (
        search_(), surfaces, walls, medialAxis, scales_.range + margin_, found_
    );
    count(surfaces);

    force.setSize(surfaces.points().size());
    force = Zero;
    law_->addForces
    (
        contactProblem{surfaces, bodies, found_, scales_.range, dt},
        force,
        statistics_
    );
    return statistics_;
}


Foam::label Foam::fsi::contact::limit
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const scalar dt,
    vectorField& force
)
{
    force.setSize(surfaces.points().size());
    force = Zero;

    // Pairs where the step would put the surfaces
    moved_ = surfaces;
    moved_.points() += dt*surfaces.velocities();
    find
    (
        limitSearch_(),
        moved_,
        walls,
        UList<contactMedialPoint>(),
        minimumGap_ + margin_,
        closing_
    );
    scalar smallestGap = GREAT;
    for (const contactPair& pair : closing_.pairs)
    {
        smallestGap = min(smallestGap, pair.gap);
    }
    if (smallestGap >= minimumGap_)
    {
        return 0;
    }

    // Their gaps at the start of the step, along the same normals
    const contactProblem problem
    {
        moved_, bodies, closing_, minimumGap_, dt
    };
    for (contactPair& pair : closing_.pairs)
    {
        pair.gap -= dt*problem.normalVelocity(pair);
    }
    limiter_.solve(problem, minimumGapRule(minimumGap_));
    limiter_.addForces(problem, force);

    label nPushed = 0;
    for (const scalar impulse : limiter_.impulses())
    {
        nPushed += impulse > 0;
    }
    return nPushed;
}


// ************************************************************************* //
