// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectContact.H"
#include "contactJumps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::fsi::objectContact::lessStandstill
(
    const vectorField& v,
    const stepLength& step
) const
{
    return
        start_.valid()
      ? v - standstill(bodies_, step.tau)
      : tmp<vectorField>(v);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectContact::push
(
    nodeVelocities& v,
    const stepLength& step
)
{
    if (!explicitForces() && !(bodies_.onlyMembranes() && !keepsForces_))
    {
        carry_.takeOut(v.change());
        calculate(lessStandstill(v.surface(), step), step);
        carry_.putIn(bodies_, force_, v.change());
    }
}


void Foam::fsi::objectContact::limit
(
    nodeVelocities& v,
    const stepLength& step
)
{
    vectorField limiting;
    const label nPushed = contact_.limit
    (
        surfaces(),
        lessStandstill(v.surface(), step),
        nodes_,
        walls_,
        step.tau,
        limiting
    );
    nLimited_ = label(bodies_.ranks().largest(nPushed));
    if (nLimited_ > 0)
    {
        addContact(bodies_, limiting, v.change());
        force_ += limiting;
    }
}


void Foam::fsi::objectContact::jump(const stepLength& step)
{
    if (start_.valid() && !explicitForces())
    {
        jumpBy(force_, step, bodies_);
        // Their impulses act over the whole step
        force_ *= step.tau/step.dt;
    }
}


// ************************************************************************* //
