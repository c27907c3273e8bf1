// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneGapLimit.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneGapLimit::membraneGapLimit
(
    const surfaceSet& surfaces,
    const UList<membraneGaps::pair>& pairs,
    const scalar deltaT,
    const scalar least,
    const vectorField& v
)
:
    surfaces_(surfaces),
    pairs_(pairs),
    deltaT_(deltaT),
    least_(least),
    speeds_(surfaces.size(), Zero)
{
    forAll(v, nodei)
    {
        scalar& speed = speeds_[surfaces.pointObject()[nodei]];
        speed = max(speed, mag(v[nodei]));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::membraneGapLimit::approach
(
    const membraneGaps::pair& p,
    const vectorField& v
) const
{
    const vector ofFace(surfaces_.interpolate(v, p.face, p.weights));
    return (ofFace - v[p.node]) & p.normal;
}


Foam::scalar Foam::fsi::membraneGapLimit::allowed
(
    const membraneGaps::pair& p
) const
{
    const scalar lacking = max(least_ - p.gap, scalar(0));
    const scalar moved =
        deltaT_
       *(
            speeds_[surfaces_.pointObject()[p.node]]
          + speeds_[surfaces_.faceObject()[p.face]]
        );
    return (max(p.gap - least_, scalar(0)) - min(0.5*lacking, moved))/deltaT_;
}


Foam::scalar Foam::fsi::membraneGapLimit::squareSum
(
    const FixedList<scalar, 3>& weights
) const
{
    scalar sum = 0;
    for (label i = 0; i < surfaces_.nNodes(); ++i)
    {
        sum += sqr(weights[i]);
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneGapLimit::addChanges
(
    const vectorField& v,
    vectorField& changes
) const
{
    for (const membraneGaps::pair& p : pairs_)
    {
        const scalar lacking = approach(p, v) - allowed(p);
        if (p.ofBody || lacking <= 0)
        {
            continue;
        }
        const surfaceFace& face = surfaces_.faces()[p.face];
        const vector change(lacking/(1 + squareSum(p.weights))*p.normal);
        changes[p.node] += change;
        for (label i = 0; i < surfaces_.nNodes(); ++i)
        {
            changes[face[i]] -= p.weights[i]*change;
        }
    }
}


void Foam::fsi::membraneGapLimit::giveWay(vectorField& v) const
{
    DynamicList<label> ofBodies;
    forAll(pairs_, pairi)
    {
        if (pairs_[pairi].ofBody)
        {
            ofBodies.append(pairi);
        }
    }
    vectorField changes(ofBodies.size() ? v.size() : 0, Zero);
    labelList nChanges(changes.size(), 0);
    const label nNodes = surfaces_.nNodes();
    for (label sweep = 0; sweep < nSweeps; ++sweep)
    {
        for (const label pairi : ofBodies)
        {
            const membraneGaps::pair& p = pairs_[pairi];
            const surfaceFace& face = surfaces_.faces()[p.face];
            const scalar lacking = approach(p, v) - allowed(p);
            const scalar change = lacking/squareSum(p.weights);
            for (label i = 0; i < nNodes && lacking > 0; ++i)
            {
                changes[face[i]] -= change*p.weights[i]*p.normal;
                ++nChanges[face[i]];
            }
        }
        for (const label pairi : ofBodies)
        {
            const surfaceFace& face = surfaces_.faces()[pairs_[pairi].face];
            for (label i = 0; i < nNodes; ++i)
            {
                v[face[i]] += changes[face[i]]/max(nChanges[face[i]], 1);
                changes[face[i]] = Zero;
                nChanges[face[i]] = 0;
            }
        }
    }
}


// ************************************************************************* //
