// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactJumps.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactViscosity
(
    const population& bodies,
    const scalar viscosity
)
{
    scalar least = GREAT;
    for (const bodyGroup& group : bodies.groups())
    {
        if (group.keepsShape() && group.movesFreely())
        {
            least = min(least, group.shape().density());
        }
    }
    return least < GREAT ? viscosity/least : 0;
}


void Foam::fsi::addContact
(
    const population& bodies,
    const vectorField& nodal,
    nodeLayout::groupNodal& v
)
{
    nodeLayout::groupNodal force;
    bodies.layout().toGroups(nodal, force);
    forAll(v, groupi)
    {
        Eigen::MatrixXd change;
        bodies.groups()[groupi].response().respond(force[groupi], change);
        v[groupi] += change;
    }
}


Foam::vectorField Foam::fsi::standstill
(
    const population& bodies,
    const scalar tau
)
{
    nodeLayout::groupNodal ofGroups(bodies.groups().size());
    forAll(ofGroups, groupi)
    {
        ofGroups[groupi] = bodies.groups()[groupi].standstill(tau);
    }
    vectorField nodal(bodies.layout().nSurface(), Zero);
    bodies.layout().toSurface(ofGroups, nodal);
    return nodal;
}


void Foam::fsi::jumpBy
(
    const vectorField& force,
    const stepLength& step,
    population& bodies
)
{
    nodeLayout::groupNodal change;
    bodies.layout().zero(change);
    addContact(bodies, force, change);
    forAll(change, groupi)
    {
        bodies.groups()[groupi].jump(step.tau/step.dt, change[groupi]);
    }
}


// ************************************************************************* //
