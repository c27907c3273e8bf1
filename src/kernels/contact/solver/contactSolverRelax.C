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


Foam::scalar Foam::fsi::contactSolver::relax
(
    const contactProblem& problem,
    const contactRule& rule,
    const label pairi
)
{
    const contactPair& pair = problem.found.pairs[pairi];
    if (pair.component >= 0)
    {
        return pair.component > 0 ? 0 : relaxFriction(problem, pairi);
    }
    const scalar moved = patches_.has(pairi) ? relaxPatch(problem, pairi) : 0;
    return max(moved, relaxRule(problem, rule, pairi));
}


Foam::scalar Foam::fsi::contactSolver::relaxRule
(
    const contactProblem& problem,
    const contactRule& rule,
    const label pairi
)
{
    const contactPair& pair = problem.found.pairs[pairi];
    const scalar compliance = compliances_[pairi];
    if (compliance < VSMALL || !problem.feelsLaw(pair))
    {
        return 0;
    }

    const scalar dt = problem.step.dt;
    const scalar u =
        velocity(problem, pairi) + addedVelocities_[pairi]
      - compliance*ruleImpulses_[pairi];

    // With the gap stretched by c an energy s w(c g)/c has the pressure w'
    const scalar c = pair.stretch;
    const scalar impulse = c*rule.impulse
    (
        contactState
        {
            problem.area(pair)/c, c*startGaps_[pairi], c*u,
            sqr(c)*compliance, dt, c*endGaps_[pairi], c
        }
    );
    endGaps_[pairi] = startGaps_[pairi] + dt*(u + compliance*impulse);

    const scalar change = impulse - ruleImpulses_[pairi];
    if (change != 0)
    {
        addImpulse(problem, pairi, change);
        impulses_[pairi] = impulse + (impulses_[pairi] - ruleImpulses_[pairi]);
        ruleImpulses_[pairi] = impulse;
    }
    if (friction_.active())
    {
        friction_.setLoad(problem, pairi, impulses_[pairi]);
    }
    return mag(change)*compliance*dt;
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
    const scalar time = problem.step.tau;
    const scalar change = patch->relax(u, problem);
    for (const auto& each : patch->pairs())
    {
        if (change != 0)
        {
            addImpulse(problem, each.first, each.second*change);
            impulses_[each.first] += each.second*change;
        }
    }
    scalar largest = mag(change)*patch->compliance();
    for (const auto& each : patch->pairs())
    {
        const label i = each.first;
        if (compliances_[i] > VSMALL)
        {
            const scalar own =
                impulses_[i] - ruleImpulses_[i]
              - each.second*patch->impulse();
            const scalar least = min
            (
                (0.5*problem.touching - problem.found.pairs[i].gap)/time,
                scalar(0)
            );
            const scalar push = max
            (
                (least - velocity(problem, i))/compliances_[i], -own
            );
            if (push != 0)
            {
                addImpulse(problem, i, push);
                impulses_[i] += push;
                largest = max(largest, mag(push)*compliances_[i]);
            }
        }
        if (friction_.active())
        {
            friction_.setLoad(problem, i, impulses_[i]);
        }
    }
    endGaps_[pairi] =
        patch->gap() + time*(u + patch->compliance()*change);
    return largest*time;
}


// ************************************************************************* //
