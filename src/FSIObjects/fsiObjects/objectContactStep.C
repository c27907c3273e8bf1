// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectContact.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::fsi::objectContact::lessStandstill
(
    const vectorField& v,
    const stepLength& step
) const
{
    if (!start_.valid())
    {
        return tmp<vectorField>(v);
    }
    const PtrList<bodyGroup>& groups = bodies_.groups();
    nodeLayout::groupNodal standstill(groups.size());
    forAll(groups, groupi)
    {
        standstill[groupi] = groups[groupi].standstill(step.tau);
    }
    vectorField nodal(v.size(), Zero);
    bodies_.layout().toSurface(standstill, nodal);
    return v - nodal;
}


Foam::scalar Foam::fsi::objectContact::implicitness(const scalar dt) const
{
    // In a step of second order impulses act on bodies that have turned, and
    // do other work than gaps give where theta is less
    return
        start_.valid()
      ? 1
      : 1 - 0.5*std::exp(-viscosity_*dt/sqr(grid_.spacing()));
}


void Foam::fsi::objectContact::respond
(
    const vectorField& nodal,
    nodeLayout::groupNodal& velocities
) const
{
    nodeLayout::groupNodal force;
    bodies_.layout().toGroups(nodal, force);
    forAll(velocities, groupi)
    {
        Eigen::MatrixXd change;
        bodies_.groups()[groupi].response().respond
        (
            force[groupi], change
        );
        velocities[groupi] += change;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectContact::keepStart()
{
    start_.reset(new surfaceSet(bodies_.surfaces()));
}


void Foam::fsi::objectContact::push
(
    nodeVelocities& v,
    const stepLength& step
)
{
    if (!explicitForces() && !(bodies_.onlyMembranes() && !keepsForces_))
    {
        calculate(lessStandstill(v.surface(), step), step);
        respond(force_, v.change());
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
        respond(limiting, v.change());
        force_ += limiting;
    }
}


void Foam::fsi::objectContact::jump(const stepLength& step)
{
    if (!start_.valid() || explicitForces())
    {
        return;
    }
    nodeLayout::groupNodal change;
    bodies_.layout().zero(change);
    respond(force_, change);
    forAll(change, groupi)
    {
        bodies_.groups()[groupi].jump(step.tau/step.dt, change[groupi]);
    }

    // Their impulses act over the whole step
    force_ *= step.tau/step.dt;
}


// ************************************************************************* //
