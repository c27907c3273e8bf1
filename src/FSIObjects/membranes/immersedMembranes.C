// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedMembranes.H"
#include "readBetween.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Warn of a membrane that is much heavier or lighter than the fluid
static void checkDensity(const bodyGroup& group, const scalar density)
{
    const scalar excess = group.shape().density()/density - 1;
    if (!group.hasWalls() && mag(excess) > 0.3)
    {
        WarningInFunction
            << "The fluid inside membranes of shape " << group.shape().name()
            << " has " << excess + 1 << " times the density of the fluid"
            << " around. It has its weight, but the inertia of the fluid"
            << " around: such objects accelerate wrongly" << nl << endl;
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedMembranes::findPassing()
{
    const surfaceSet& surfaces = bodies_.surfaces();
    passes_.setSize(surfaces.size());
    forAll(passes_, objecti)
    {
        passes_[objecti] =
            objects_.sides().anyOpen() && !surfaces.hasWalls(objecti)
         && objects_.sides().reachedOut(surfaces.bounds(objecti));
    }
}


template<class Action>
void Foam::fsi::immersedMembranes::forMembranes(const Action& action) const
{
    const surfaceSet& surfaces = bodies_.surfaces();
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (!surfaces.hasWalls(objecti) && !passes_[objecti])
        {
            const label start = surfaces.pointStart()[objecti];
            action(start, surfaces.pointStart()[objecti + 1] - start);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedMembranes::immersedMembranes
(
    fsiObjects& objects,
    const interfaceGeometry& geometry,
    fluidViscosity& viscosity
)
:
    objects_(objects),
    bodies_(objects.bodies()),
    geometry_(geometry),
    fluid_(objects.fluid()),
    gravity_(objects.gravity()),
    width_(readKernel(objects)),
    viscosity_(viscosity)
{
    bool any = false;
    for (const bodyGroup& group : bodies_.groups())
    {
        any = any || !group.hasWalls();
        checkDensity(group, fluid_.density);
    }
    if (any && !bodies_.onlyMembranes())
    {
        ghosts_.reset(new wallGhosts(geometry, objects.levelSet()));
    }
    const dictionary& dict = objects.properties().subOrEmptyDict("membranes");
    const scalar h = geometry.grid().spacing();
    const scalar least = h*readScalarBetween(dict, "minimumGap", 0.1, 0, 1);
    if (any)
    {
        limits_.reset(new membraneLimits(objects, least));
        faces_.reset(new faceLattice(geometry.grid()));
        transfer_.reset(new staggeredTransfer(faces_->lattice(), width_));
    }
    if (any && dict.found("contact"))
    {
        contact_.reset(new membraneContact(objects, dict.subDict("contact")));
    }
    if (viscosityContrast::wanted(bodies_, fluid_))
    {
        contrast_.reset(new viscosityContrast(*faces_, fluid_));
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::label Foam::fsi::immersedMembranes::readKernel(const fsiObjects& objects)
{
    const dictionary dict(objects.properties().subOrEmptyDict("membranes"));
    checkKeys(dict, {"kernel", "minimumGap", "contact"});
    checkSubDicts(dict, {"contact"});
    return readBetween(dict, "kernel", 3, 2, 4);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::immersedMembranes::spread
(
    const volVectorField& U,
    const stepLength& step,
    nodeLayout::groupNodal& force
)
{
    if (!active())
    {
        return;
    }
    findPassing();
    if (contact_.valid())
    {
        addContact(step.dt, force);
    }
    setForces(step.dt, force);
    faces_->setZero(values_);
    const pointField& x = bodies_.surfaces().points();
    forMembranes([&](const label start, const label n)
    {
        transfer_->spread
        (
            SubList<point>(x, n, start),
            SubList<vector>(nodal_, n, start),
            values_
        );
    });
    faces_->setCells(U, values_, force_);
    if (ghosts_.valid())
    {
        partialForces part(x.size());
        ghosts_->update();
        ghosts_->bringBack(objects_.surfaces(), force_, part.mine());
        part.mine() *= fluid_.density;
        addPart(part, force);
    }
    if (contrast_.valid())
    {
        contrast_->update(bodies_, viscosity_);
    }
}


void Foam::fsi::immersedMembranes::addTo(fvVectorMatrix& UEqn) const
{
    if (active())
    {
        UEqn.source() += force_;
    }
    if (contrast_.valid() && !viscosity_.hasLaw())
    {
        viscosity_.addTo(UEqn);
    }
}


void Foam::fsi::immersedMembranes::correctPressure
(
    const volScalarField& last,
    const stepLength& step,
    volScalarField& p
) const
{
    if (active())
    {
        // A larger viscosity inside would make short waves grow
        addRotationalPart(geometry_, viscosity_.smaller(), last, step.tau, p);
    }
}


void Foam::fsi::immersedMembranes::setVelocities
(
    const surfaceScalarField& phi,
    const volVectorField& U,
    const scalar deltaT,
    nodeLayout::groupNodal& v
)
{
    if (!active())
    {
        return;
    }
    tmp<volVectorField> extended(U);
    if (ghosts_.valid())
    {
        extended = newTmp<volVectorField>("extended", U);
        ghosts_->extend(extended.ref());
    }
    faces_->setVelocities(phi, geometry_.openArea(), extended(), values_);
    const pointField& x = bodies_.surfaces().points();
    partialForces part(x.size());
    forMembranes([&](const label start, const label n)
    {
        SubList<vector> nodes(part.mine(), n, start);
        transfer_->interpolate(SubList<point>(x, n, start), values_, nodes);
    });
    nodeLayout::groupNodal velocity;
    bodies_.layout().toGroups(part.collect(bodies_.ranks()), velocity);
    limits_->set(objects_.surfaces(), deltaT, passes_, velocity, slip_, v);
}


// ************************************************************************* //
