// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedStep.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "filmPressure.H"
#include "objectResponse.H"
#include "openfoamVersion.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(immersedStep, 0);
    addToRunTimeSelectionTable(fsiStep, immersedStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedStep::immersedStep
(
    fsiObjects& objects,
    const flowFields& flow,
    const dictionary& dict
)
:
    fluidStep(objects, flow),
    pressure_(objects, geometry_, walls_, flow.p),
    viscous_
    (
        objects.bodies(), geometry_, objects.fluid(), pressure_.multigrid(),
        objects.log()
    ),
    term_(objects.bodies(), walls_, objects.fluid().density, true),
    sudden_(objects, geometry_, walls_),
    passes_(dict, objects.bodies().onlyMembranes()),
    profiles_(geometry_, objects.fluid()),
    balance_
    (
        objects.bodies(), geometry_, objects.levelSet(),
        objects.fluid().density
    ),
    membranes_(objects, geometry_, viscosity_)
{
    checkKeys(dict, {"type", "passes", "passTolerance"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::immersedStep::advance(const flowSources& sources)
{
    // Objects leave and come in; gravity and driving force
    if (begin())
    {
        balance_.renew();
    }
    if (countsLayer())
    {
        balance_.begin(U_);
    }
    if (rule_.secondOrder())
    {
        objects_.expect(rule_);
        moveWalls();
    }

    viscosity_.update(U_, phi_);

    // Objects as if alone, with the last load of the fluid
    groupNodal force(objects_.forces(step()));
    membranes_.spread(U_, step(), force);
    predict(force);

    tmp<surfaceScalarField> convectiveFlux(moved(rule_.flux(phi_)));
    expectedChange change(error_.rate(), step().dt);
    do
    {
        const stepTimer::section fluid
        (
            objects_.timer(), stepTimer::part::fluid
        );
        // Velocities of cells and nodes with the last pressure
        solveMomentum(convectiveFlux(), change, sources);
        objects_.constrain(velocity_, step());
        objects_.push(velocity_, step());
        profiles_.push(velocity_.surface(), step().tau);

        // The pressure that makes the flow free of divergence, to which
        // objects give way
        setFlux
        (
            convectiveFlux, oldPressure_(), gradient_(), velocity_.surface(),
            membranes_.fadingEigenvalue()
        );
        solvePressure();
        correctVelocity(sources);
        change = expectedChange();
    }
    while (passAgain(convectiveFlux));

    // The objects get what the fluid lost, and move
    finishFluid(velocity_.surface(), passes_.error());
    finish();
    membranes_.correctPressure(oldPressure_(), step(), p_);
    objects_.move(velocity_.groups(), step());

    // The surfaces are where they are: level set, walls, new cells
    moveWalls();
    hydrodynamicForce_ += balance_.close(step());
    endStep();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedStep::setGradient()
{
    gradient_ = gradients_.openGradient(oldPressure_());
    walls_.gradientForce(gradient_(), gradientForce_);
    gradientForce_ *= objects_.fluid().density;
    gradients_.extendGradient(gradient_.ref());
}


void Foam::fsi::immersedStep::predict(groupNodal force)
{
    const stepTimer::section solids(objects_.timer(), stepTimer::part::solids);
    addOutsidePressure(force);
    balance_.pay(step());
    oldPressure_.reset
    (
        new volScalarField
        (
            IOobject
            (
                p_.name(), nameOf(p_.mesh().time()), p_.mesh(),
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            p_
        )
    );
    passes_.begin();
    profiles_.begin(objects_.bodies().surfaces().velocities());
    walls_.setFilms(profiles_.answered(step().tau), objects_.fluid().viscosity);
    volScalarField& last = oldPressure_();
    sudden_.answer(last, pressure_, step());
    fillFilmCells(geometry_, last);
    setGradient();

    population& bodies = objects_.bodies();
    groupNodal load(pressureForce(walls_.atWalls(last.primitiveField())));
    addNetForce(bodies, gradientForce_ + balance_.payment(), load);
    const groupNodal rest(splitLoads(bodies, load));
    nodeLayout::add(force, load);
    predictObjects
    (
        bodies, p_.time().value() - step().dt, step(), load, predicted_
    );
    addResponse(bodies, rest, predicted_);
    objects_.contact().carry().begin(bodies, predicted_);
    velocity_.change() = predicted_;
}


bool Foam::fsi::immersedStep::countsLayer() const
{
    return !objects_.bodies().onlyMembranes();
}


void Foam::fsi::immersedStep::settle()
{
    if (objects_.bodies().onlyMembranes())
    {
        return;
    }
    partialForces loss(gradientForce_.size());
    momentum_.cut().addLoss
    (
        objects_.levelSet(), objects_.surfaces(), U_, velocity_.surface(), loss
    );
    // Films have already given them this of the new gradient
    walls_.inFilms().addForce
    (
        walls_.atWalls(oldPressure_().primitiveField() - p_.primitiveField()),
        loss.mine()
    );
    vectorField& force = loss.collectWalls(objects_.bodies().ranks());
    force *= objects_.fluid().density;
    vectorField links;
    viscous_.linkForceBeyond(U_, links);
    balance_.owe(force + links + newGradientForce_ - gradientForce_, step());
}


void Foam::fsi::immersedStep::finish()
{
    pressure_.endStep(p_);
    settle();
    membranes_.setVelocities(phi_, U_, step().dt, velocity_.change());
    objects_.limit(velocity_, step());
    objects_.constrain(velocity_, step());

    population& bodies = objects_.bodies();
    vectorField nodal;
    walls_.transpose(p_.primitiveField(), nodal);
    nodal = linkForce_ + objects_.fluid().density*nodal;
    hydrodynamicForce_ = nodal + gradientForce_;
    groupNodal load;
    bodies.layout().toGroups(nodal, load);
    addNetForce(bodies, gradientForce_ + balance_.payment(), load);
    keepLoads(bodies, load);
}


void Foam::fsi::immersedStep::moveWalls()
{
    if (countsLayer())
    {
        balance_.beginMove
        (
            U_, objects_.bodies().surfaces().velocities(), step()
        );
    }
    auto nodal(objects_.contact().withForces(balance_.nodal()));
    nodal.push_back(&hydrodynamicForce_);
    beginMove(nodal);
    if (countsLayer())
    {
        balance_.endMove(U_, step());
    }
    endMove();
}


// ************************************************************************* //
