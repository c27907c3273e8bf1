// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneGapLimit.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::membraneGapLimit::excess
(
    const membraneGaps::pair& p,
    const vectorField& v
) const
{
    const vector ofFace(surfaces_.interpolate(v, p.face, p.weights));
    // A body that goes on pushing loses a part of its gap in each step, which
    // the correction of the volume takes
    const scalar given = p.ofBody ? 0.5 : 0;
    const scalar lacking = max(least_ - p.gap, scalar(0));
    const scalar kept = min(p.gap, least_) + given*lacking;
    return ((ofFace - v[p.node]) & p.normal) - (p.gap - kept)/deltaT_;
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
        const scalar lacking = excess(p, v);
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
            const scalar lacking = excess(p, v);
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
