// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactJumps.H"
#include "objectContact.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::checkRoughness
(
    const dictionary& dict,
    const population& bodies
)
{
    bool any = false;
    for (const bodyGroup& group : bodies.groups())
    {
        any = any || group.keepsShape();
    }
    if (dict.found("roughness") && !any)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'roughness' in dictionary " << dict.name() << " is for"
            << " rigid bodies, but no shape is rigid" << exit(FatalIOError);
    }
}


void Foam::fsi::setFluid
(
    const population& bodies,
    const fluidProperties& fluid,
    const cartesianMesh& grid,
    contactStep& step
)
{
    const scalar viscosity = fluid.dynamicViscosity();
    scalar least = GREAT;
    for (const bodyGroup& group : bodies.groups())
    {
        if (group.keepsShape() && group.movesFreely())
        {
            least = min(least, group.shape().density());
        }
    }
    if (least < GREAT)
    {
        step.rebound =
            std::exp(-viscosity/least*step.dt/sqr(grid.spacing()));
    }
    step.film.viscosity = viscosity;
    step.film.thickness = grid.thickness();
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
