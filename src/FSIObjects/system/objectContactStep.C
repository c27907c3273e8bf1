// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectContact.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::fsi::objectContact::lessStandstill
(
    const vectorField& v
) const
{
    if (!start_.valid())
    {
        return tmp<vectorField>(v);
    }
    const PtrList<bodyGroup>& groups = system_.objects.groups();
    fsiSystem::groupNodal standstill(groups.size());
    forAll(groups, groupi)
    {
        standstill[groupi] = groups[groupi].standstill(system_.stepTime());
    }
    vectorField nodal(v.size(), Zero);
    system_.objects.layout().toSurface(standstill, nodal);
    return v - nodal;
}


void Foam::fsi::objectContact::respond(nodeVelocities& v) const
{
    fsiSystem::groupNodal force;
    system_.objects.layout().toGroups(force_, force);
    fsiSystem::groupNodal& velocities = v.change();
    forAll(velocities, groupi)
    {
        Eigen::MatrixXd change;
        system_.objects.groups()[groupi].response().respond
        (
            force[groupi], change
        );
        velocities[groupi] += change;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectContact::keepStart()
{
    start_.reset(new surfaceSet(system_.objects.surfaces()));
}


void Foam::fsi::objectContact::push(nodeVelocities& v)
{
    if (!explicitForces())
    {
        calculate(lessStandstill(v.surface()));
        respond(v);
    }
}


void Foam::fsi::objectContact::limit(nodeVelocities& v)
{
    nLimited_ = contact_.limit
    (
        surfaces(),
        lessStandstill(v.surface()),
        bodies_,
        walls_,
        system_.stepTime(),
        force_
    );
    if (nLimited_ > 0)
    {
        respond(v);
    }
}


// ************************************************************************* //
