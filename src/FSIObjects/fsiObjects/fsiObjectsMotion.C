// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjects.H"
#include "motionCheck.H"
#include "timeRule.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fsiObjects::updateSurfaces()
{
    if (images_.cyclic())
    {
        bodies_.wrap(images_);
    }
    bodies_.updateSurfaces();
    updateImages();
}


void Foam::fsi::fsiObjects::updateImages()
{
    const scalar outside = levelSet_->bandWidth() + grid_.spacing();
    surfaces_ = &images_.update(bodies_.surfaces(), outside);
}


void Foam::fsi::fsiObjects::renew()
{
    updateSurfaces();
    levelSet_->initialise(surfaces());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::fsiObjects::feed()
{
    const stepTimer::section solids(timer_, stepTimer::part::solids);
    const bool changed = boundaries_.update(mesh_.time().value() - deltaT());
    if (changed)
    {
        const stepTimer::section levelSet(timer_, stepTimer::part::levelSet);
        renew();
    }
    return changed;
}


void Foam::fsi::fsiObjects::drive(const volVectorField& U)
{
    const stepTimer::section solids(timer_, stepTimer::part::solids);
    driving_->update(U, bodies_, fluid_.density);
    if (log_.full())
    {
        driving_->log(Info);
    }
    contact_.setWallVelocities(U);
}


void Foam::fsi::fsiObjects::expect(const timeRule& rule)
{
    const stepTimer::section solids(timer_, stepTimer::part::solids);
    if (bodies_.nAll() && !levelSet_->secondOrder())
    {
        FatalIOErrorInFunction(properties_)
            << "Level set " << levelSet_->type() << " is of first order in"
            << " time: take Euler for ddtSchemes, or the level set rebuilt"
            << exit(FatalIOError);
    }
    contact_.keepStart();
    for (bodyGroup& group : bodies_.groups())
    {
        group.begin(mesh_.time().value(), deltaT(), rule.ratio());
    }
    updateSurfaces();
}


Foam::fsi::fsiObjects::groupNodal Foam::fsi::fsiObjects::forces
(
    const stepLength& step
)
{
    const stepTimer::section solids(timer_, stepTimer::part::solids);
    groupNodal force;
    bodies_.layout().zero(force);
    forAll(force, groupi)
    {
        bodyGroup& group = bodies_.groups()[groupi];
        // Membranes have no mass, see immersedMembranes
        vector a(Zero);
        if (group.hasWalls())
        {
            a = fluid_.accelerationOf
            (
                group.shape().density(), gravity_, driving_->acceleration()
            );
            a -= frame_.acceleration();
        }
        loads_.add(mesh_.time(), groupi, group, a, force[groupi]);
        group.prepareResponse(step.tau);
    }
    const stepTimer::section contact(timer_, stepTimer::part::contact);
    contact_.addForce(force, step);
    return force;
}


void Foam::fsi::fsiObjects::constrain
(
    nodeVelocities& v,
    const stepLength& step
) const
{
    groupNodal& velocities = v.change();
    forAll(velocities, groupi)
    {
        bodies_.groups()[groupi].constrain(step.tau, velocities[groupi]);
    }
}


void Foam::fsi::fsiObjects::push(nodeVelocities& v, const stepLength& step)
{
    const stepTimer::section contact(timer_, stepTimer::part::contact);
    contact_.push(v, step);
}


void Foam::fsi::fsiObjects::limit(nodeVelocities& v, const stepLength& step)
{
    const stepTimer::section contact(timer_, stepTimer::part::contact);
    contact_.limit(v, step);
}


void Foam::fsi::fsiObjects::move(const groupNodal& v, const stepLength& step)
{
    const stepTimer::section solids(timer_, stepTimer::part::solids);
    contact_.carry().keep(contact_.forces(), v, bodies_);
    forAll(v, groupi)
    {
        bodies_.groups()[groupi].move(step.tau, v[groupi]);
    }
    contact_.jump(step);
    updateSurfaces();
    motionCheck(bodies_, mesh_.time()).check
    (
        grid_.bounds().span(), grid_.spacing(), sides_.period()
    );
}


void Foam::fsi::fsiObjects::moveLevelSet
(
    const std::vector<vectorField*>& nodal
)
{
    if (!bodies_.stepRuns())
    {
        if (bodies_.migrate(nodal))
        {
            updateImages();
        }
        const stepTimer::section contact(timer_, stepTimer::part::contact);
        contact_.measure();
    }
    const stepTimer::section levelSet(timer_, stepTimer::part::levelSet);
    levelSet_->move(surfaces(), deltaT());
}


// ************************************************************************* //
