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


// ************************************************************************* //
