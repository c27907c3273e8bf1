// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidStep.H"
#include "evaluateCoupled.H"
#include "exchangeFields.H"
#include "fieldChecks.H"
#include "motionCheck.H"
#include "newCells.H"
#include "outflowBalance.H"
#include "solidVelocity.H"
#include "stockInput.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fluidStep::updateGeometry()
{
    geometry_.update(objects_.levelSet(), objects_.surfaces());
    geometry_.setWallVelocities(U_);
    walls_.update(objects_.bodies().surfaces());
}


void Foam::fsi::fluidStep::setSolidVelocity()
{
    const surfaceSet& all = objects_.surfaces();
    fsi::setSolidVelocity(geometry_, objects_.levelSet(), all, U_);
}


Foam::fsi::fluidStep::groupNodal Foam::fsi::fluidStep::inGroups
(
    const vectorField& nodal
) const
{
    groupNodal force;
    const scalar density = objects_.fluid().density;
    objects_.bodies().layout().toGroups(density*nodal, force);
    return force;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fluidStep::fluidStep
(
    fsiObjects& objects,
    const flowFields& flow
)
:
    fsiStep(objects),
    p_(flow.p),
    U_(flow.U),
    phi_(flow.phi),
    wall_(wallTreatment::New(objects.properties())),
    geometry_(objects.grid(), *wall_),
    viscosity_(objects, geometry_, flow.law),
    walls_(geometry_, objects.bodies().ranks()),
    faces_(geometry_),
    rule_(U_.mesh()),
    gradients_(geometry_),
    momentum_(geometry_, rule_),
    flux_(geometry_, faces_, rule_),
    level_(p_, objects.grid())
{
    evaluateCoupled(U_);
    evaluateCoupled(p_);
    immersedMomentum::interpolation(phi_);
    stockInput::checkFluid(U_.mesh(), flow.law);
    updateGeometry();
    fieldChecks::check
    (
        p_, U_, objects.bodies(), geometry_, objects.frame().active()
    );
    objects.frame().check(U_, objects.bodies(), objects.properties());
    setSolidVelocity();
    scalars_.reset(new carriedScalars(objects, geometry_));
    if (objects.driving().type() == "none")
    {
        motionCheck(objects.bodies(), U_.time()).checkWeight
        (
            U_.mesh().boundaryMesh(), objects.sides().period(),
            objects.gravity(), objects.fluid().density
        );
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::fsi::fluidStep::begin()
{
    level_.remove();
    rule_.begin(U_, phi_);
    const bool changed = feed();
    if (changed)
    {
        updateGeometry();
    }
    objects_.frame().follow
    (
        objects_.bodies(), rule_.length(), backwardStep{rule_.ratio()}, U_
    );
    objects_.drive(U_);
    return changed;
}


void Foam::fsi::fluidStep::addOutsidePressure(groupNodal& force)
{
    if (!objects_.sides().anyOpen())
    {
        return;
    }
    vectorField nodal;
    walls_.setOutside(p_, nodal);
    nodeLayout::add(inGroups(nodal), force);
}


void Foam::fsi::fluidStep::setGivenFlux(const vectorField& wallVelocity)
{
    if (objects_.sides().anyOpen())
    {
        const population& bodies = objects_.bodies();
        boolList isFree(bodies.nHeld());
        forAll(isFree, objecti)
        {
            isFree[objecti] = bodies.movesFreely(objecti);
        }
        walls_.setGivenFlux(p_, U_, isFree, wallVelocity);
    }
    if (p_.needReference())
    {
        balanceOutflow(phi_, U_, walls_.givenFlux());
    }
}


Foam::fsi::fluidStep::groupNodal Foam::fsi::fluidStep::pressureForce
(
    const scalarField& p,
    const bool films
) const
{
    vectorField nodal;
    walls_.transposeAtWalls(p, nodal, films);
    return inGroups(nodal);
}


Foam::tmp<Foam::fvVectorMatrix> Foam::fsi::fluidStep::momentum
(
    const surfaceScalarField& convectiveFlux,
    const volVectorField& gradP,
    const flowSources& sources
)
{
    const vector acceleration
    (
        objects_.driving().acceleration() - objects_.frame().acceleration()
    );
    tmp<fvVectorMatrix> tUEqn
    (
        momentum_.momentum
        (
            convectiveFlux,
            U_,
            objects_.fluid().viscosity,
            gradP,
            acceleration
        )
    );
    fvVectorMatrix& UEqn = tUEqn.ref();
    if (viscosity_.hasLaw())
    {
        viscosity_.addTo(UEqn);
    }
    filmForces& inFilms = flux_.forcesInFilms();
    inFilms.begin(scalars_->buoyant() || sources.any(), UEqn.source());
    scalars_->addBuoyancy(UEqn.source());
    sources.apply(UEqn, U_);
    inFilms.end(acceleration, UEqn.source());
    momentum_.constrain(UEqn);
    return tUEqn;
}


void Foam::fsi::fluidStep::moveFlux(surfaceScalarField& flux)
{
    if (flux_.moved().moved())
    {
        flux_.moved().setFlux(flux);
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::fsi::fluidStep::moved
(
    tmp<surfaceScalarField> tflux
)
{
    if (rule_.secondOrder() && flux_.moved().moved())
    {
        tflux = newTmp<surfaceScalarField>("convectiveFlux", tflux());
        moveFlux(tflux.ref());
    }
    return tflux;
}


void Foam::fsi::fluidStep::setFlux
(
    tmp<surfaceScalarField>& convectiveFlux,
    const volScalarField& p,
    const volVectorField& gradP,
    const vectorField& wallVelocity,
    const scalar eigenvalue
)
{
    tmp<surfaceScalarField> tnew
    (
        flux_.faceFlux
        (
            U_, gradP, p, wallVelocity, viscosity_.around(), eigenvalue
        )
    );
    if (&convectiveFlux() == &phi_)
    {
        // Further passes of Euler convect with the old one
        exchangeFields(phi_, tnew.ref());
        convectiveFlux = tnew;
    }
    else
    {
        phi_ = tnew;
    }
}


void Foam::fsi::fluidStep::finishFluid
(
    const vectorField& wallVelocity,
    const scalar ofSplitting
)
{
    const stepTimer::section fluid(objects_.timer(), stepTimer::part::fluid);
    flux_.storeFaceVelocity(phi_, U_, wallVelocity, viscosity_.around());
    error_.measure
    (
        U_, geometry_.fluidCell(), ofSplitting, objects_.restSpeed()
    );
}


void Foam::fsi::fluidStep::beginMove(const std::vector<vectorField*>& nodal)
{
    flux_.beginMove(U_, objects_.bodies().surfaces().velocities());
    objects_.moveLevelSet(nodal);
    const stepTimer::section coupling
    (
        objects_.timer(), stepTimer::part::coupling
    );
    wasActive_ = geometry_.activeCell();
    updateGeometry();
}


void Foam::fsi::fluidStep::endMove()
{
    const stepTimer::section coupling
    (
        objects_.timer(), stepTimer::part::coupling
    );
    fillNewCells(wasActive_, geometry_.activeCell(), p_);
    wasActive_.clear();
    setSolidVelocity();
    flux_.endMove
    (
        U_,
        objects_.bodies().surfaces().velocities(),
        objects_.fluid().viscosity
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fluidStep::describe(Ostream& os) const
{
    fsiStep::describe(os);
    os  << ", wall " << wall_->type();
}


// ************************************************************************* //
