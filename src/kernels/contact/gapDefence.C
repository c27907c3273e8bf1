// SPDX-License-Identifier: GPL-3.0-or-later

#include "gapDefence.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

namespace
{

//- Rule: a gap does not shrink below the minimum, or below what it
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

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::gapDefence::gapDefence
(
    const scalar minimumGap,
    const scalar margin,
    const scalar patchDepth,
    const direction nDims,
    periodicImages& images
)
:
    minimumGap_(minimumGap),
    margin_(margin),
    patchDepth_(patchDepth),
    finder_(dictionary(), images),
    limiter_(dictionary()),
    moved_(nDims)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::gapDefence::mayClose
(
    const surfaceSet& surfaces,
    const vectorField& v,
    const contactPairs& found,
    const UList<contactWall>& walls,
    const scalar dt
) const
{
    // Mean velocity of each object, and how far its nodes' are from it
    vectorField mean(surfaces.size(), Zero);
    scalarField spread(surfaces.size(), Zero);
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label end = surfaces.pointStart()[objecti + 1];
        for (label nodei = start; nodei < end; ++nodei)
        {
            mean[objecti] += v[nodei]/(end - start);
        }
        for (label nodei = start; nodei < end; ++nodei)
        {
            spread[objecti] =
                max(spread[objecti], mag(v[nodei] - mean[objecti]));
        }
    }

    // A pair has the nearest point of the other object, and all of that object
    // comes nearer by this speed at most
    for (const contactPair& pair : found.pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        const scalar approach =
            pair.wall >= 0 && walls[pair.wall].whole()
          ? -(v[pair.node] & pair.normal)
          : pair.wall >= 0
          ? mag(mean[own]) + spread[own]
          : mag(v[pair.node] - mean[pair.other]) + spread[pair.other];
        if (pair.gap - dt*approach < minimumGap_)
        {
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::gapDefence::limit
(
    const surfaceSet& surfaces,
    const vectorField& velocities,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const scalar dt,
    const contactPairs* found,
    vectorField& force,
    const contactExchange* exchange
)
{
    force.setSize(surfaces.points().size());
    force = Zero;
    const auto ofAll = [&](const scalar value)
    {
        return exchange ? exchange->largest(value) : value;
    };
    const bool needed =
        !found || mayClose(surfaces, velocities, *found, walls, dt);
    if (ofAll(needed ? 1 : 0) == 0)
    {
        return 0;
    }

    // Pairs where the step would put the surfaces
    moved_ = surfaces;
    moved_.points() += dt*velocities;
    finder_.find
    (
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
    if (-ofAll(-smallestGap) >= minimumGap_)
    {
        return 0;
    }

    // Their gaps at the start of the step, along the same normals
    contactStep step(dt);
    step.rebound = 0;
    const contactProblem problem
    {
        moved_, velocities, bodies, closing_, minimumGap_, step, exchange,
        minimumGap_, patchDepth_, false
    };
    for (contactPair& pair : closing_.pairs)
    {
        pair.gap -= dt*problem.normalVelocity(pair, velocities);
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
