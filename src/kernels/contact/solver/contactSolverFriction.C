// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactSolver.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactSolver::velocity
(
    const contactProblem& problem,
    const label pairi
) const
{
    return
        response_.normalVelocity(pairi)
      + (problem.exchange ? shared_.velocity(pairi) : 0);
}


void Foam::fsi::contactSolver::addImpulse
(
    const contactProblem& problem,
    const label pairi,
    const scalar change
)
{
    response_.addImpulse(pairi, change);
    if (problem.exchange)
    {
        shared_.addImpulse(pairi, change);
    }
}


Foam::scalar Foam::fsi::contactSolver::relaxFriction
(
    const contactProblem& problem,
    const label pairi
)
{
    const label normali = friction_.pairOf(pairi);
    endGaps_[pairi] = endGaps_[normali];

    scalar compliance = 0;
    vector slip(Zero), last(Zero);
    for (label d = 0; d < friction_.nDims(); ++d)
    {
        compliance += compliances_[pairi + d]/(friction_.nDims() - 1);
        slip[d] = velocity(problem, pairi + d);
        last[d] = impulses_[pairi + d];
    }
    if (compliance < VSMALL)
    {
        return 0;
    }
    slip -= contactFriction::wallVelocity(problem, problem.found.pairs[pairi]);

    const vector impulse(friction_.limited(normali, last - slip/compliance));
    for (label d = 0; d < friction_.nDims(); ++d)
    {
        if (impulse[d] != last[d])
        {
            addImpulse(problem, pairi + d, impulse[d] - last[d]);
            impulses_[pairi + d] = impulse[d];
        }
    }
    return slipWeight*mag(impulse - last)*compliance*problem.step.tau;
}


Foam::scalar Foam::fsi::contactSolver::relaxPatch
(
    const contactProblem& problem,
    const label pairi
)
{
    contactPatches::patch* patch = patches_.visited(pairi);
    if (!patch || patch->compliance() < VSMALL)
    {
        return 0;
    }
    scalar u = 0;
    for (const auto& each : patch->pairs())
    {
        u += each.second*velocity(problem, each.first);
    }
    const scalar change = patch->relax(u, problem);
    for (const auto& each : patch->pairs())
    {
        if (change != 0)
        {
            addImpulse(problem, each.first, each.second*change);
            impulses_[each.first] += each.second*change;
        }
        if (friction_.active())
        {
            friction_.setLoad
            (
                problem, each.first, impulses_[each.first], 0,
                startGaps_[each.first], startGaps_[each.first]
            );
        }
    }
    const scalar time = problem.step.tau;
    endGaps_[pairi] =
        patch->gap() + time*(u + patch->compliance()*change);
    return mag(change)*patch->compliance()*time;
}


// ************************************************************************* //
