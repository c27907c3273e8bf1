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

    virtual scalar impulse(const contactState& pair) const
    {
        const scalar least = min((minimum_ - pair.gap)/pair.dt, 0.0);
        return max(least - pair.velocity, 0.0)/pair.compliance;
    }
};

} // End anonymous namespace


//- Read the ranges and check the entries
static contactScales readScales
(
    const dictionary& dict,
    const scalar spacing,
    const scalar youngsModulus,
    const scalar viscosity
)
{
    checkKeys
    (
        dict,
        {"range", "margin", "minimumGap", "search", "law", "lubrication"}
    );
    checkSubDicts(dict, {"search", "law", "lubrication"});
    const scalar range = contact::readRange(dict, spacing);
    return {spacing, range, youngsModulus, viscosity};
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
    const scalar viscosity,
    const periodicImages& images
)
:
    scales_(readScales(dict, spacing, youngsModulus, viscosity)),
    margin_(readNonNegative(dict, "margin", 1)*spacing),
    minimumGap_(readPositive(dict, "minimumGap", 0.1)*spacing),
    search_(contactSearch::New(dict.subOrEmptyDict("search"))),
    law_(contactLaw::New(dict.subOrEmptyDict("law"), scales_)),
    film_(lubrication::New(dict.subOrEmptyDict("lubrication"), scales_)),
    images_(images),
    limiter_(dictionary()),
    limitSearch_(contactSearch::New(dictionary())),
    moved_(nDims)
{
    if (film_->active() && !law_->takesLubrication())
    {
        FatalIOErrorInFunction(dict)
            << "The law of dictionary " << dict.name() << " is '"
            << law_->type() << "', which knows no lubrication (entry"
            << " 'lubrication'); laws derived from potentialContact do:"
            << " elastic, Morse, LennardJones" << exit(FatalIOError);
    }
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

void Foam::fsi::contact::setStretches
(
    const surfaceSet& surfaces,
    const contactBodies& bodies
)
{
    for (contactPair& pair : found_.pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        if (pair.other == own)
        {
            const scalar rest = bodies.restDistance(surfaces, pair);
            pair.stretch = max(scales_.range/max(rest, VSMALL), 1.0);
        }
    }
}


Foam::fsi::contactProblem Foam::fsi::contact::problem
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const scalar dt
) const
{
    return {surfaces, velocities, bodies, found_, film_(), scales_.range, dt};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::contact::readRange
(
    const dictionary& dict,
    const scalar spacing
)
{
    const scalar cells = readPositive(dict, "range", 3);
    if (cells < 0.01)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'range' in dictionary " << dict.name() << " is " << cells
            << "; it is a number of mesh cells, at least 0.01. Without contact:"
            << " law { type none; }" << exit(FatalIOError);
    }
    return cells*spacing;
}


const Foam::fsi::contactStatistics& Foam::fsi::contact::measure
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis
)
{
    if (!searched(surfaces))
    {
        const scalar range = scales_.range + margin_;
        find
        (
            search_(), surfaces, bodies, walls, medialAxis, range, found_
        );
        setStretches(surfaces, bodies);
        searched_ = surfaces.points();
    }
    count(surfaces);
    statistics_.potentialEnergy =
        law_->potentialEnergy
        (
            problem(surfaces, surfaces.velocities(), bodies, GREAT)
        );
    return statistics_;
}


const Foam::fsi::contactStatistics& Foam::fsi::contact::calculate
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis,
    const scalar dt,
    vectorField& force
)
{
    measure(surfaces, bodies, walls, medialAxis);

    film_->update(surfaces);
    force.setSize(surfaces.points().size());
    force = Zero;
    law_->addForces
    (
        problem(surfaces, velocities, bodies, dt), force, statistics_
    );
    return statistics_;
}


Foam::label Foam::fsi::contact::limit
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const scalar dt,
    vectorField& force
)
{
    force.setSize(surfaces.points().size());
    force = Zero;
    if (!mayClose(surfaces, velocities, dt))
    {
        return 0;
    }

    // Pairs where the step would put the surfaces
    moved_ = surfaces;
    moved_.points() += dt*velocities;
    find
    (
        limitSearch_(),
        moved_,
        bodies,
        walls,
        UList<medialAxisPoint>(),
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
        moved_, velocities, bodies, closing_, noFilm_, minimumGap_, dt
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
