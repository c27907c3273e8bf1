// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidImplicit.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "filmPressure.H"
#include "objectResponse.H"
#include "openfoamVersion.H"
#include "openLaplacian.H"
#include "sharedPrediction.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(solidImplicit, 0);
    addToRunTimeSelectionTable(couplingModel, solidImplicit, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::solidImplicit::solidImplicit
(
    fsiSystem& system,
    stepTimer& timer,
    const dictionary& dict
)
:
    couplingModel(system, timer, dict),
    viscous_(system),
    term_(system),
    conductance_(system),
    sudden_(system),
    passes_(dict)
{
    checkKeys(dict, {"type", "passes", "passTolerance"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::solidImplicit::pressureForce
(
    const scalarField& p,
    groupNodal& force
) const
{
    vectorField nodal;
    system_.walls.transposeAtWalls(p, nodal);
    nodal *= system_.fluidDensity;
    system_.objects.layout().toGroups(nodal, force);
}


void Foam::fsi::solidImplicit::setGradient()
{
    gradient_ = system_.fluid.openGradient(oldPressure_());
    system_.walls.gradientForce(gradient_(), gradientForce_);
    gradientForce_ *= system_.fluidDensity;
    system_.fluid.extendGradient(gradient_.ref());
}


void Foam::fsi::solidImplicit::predict
(
    const scalar time,
    groupNodal& load,
    const groupNodal& force
)
{
    groupNodal rest(load.size());
    forAll(rest, groupi)
    {
        bodyGroup& group = system_.objects.groups()[groupi];
        rest[groupi] = group.splitLoad(load[groupi]);
        load[groupi] += force[groupi];
    }
    addRigidForce(system_, gradientForce_, load);
    predictShared(system_.objects, time, system_.stepTime(), load, predicted_);
    addResponse(system_.objects, rest, predicted_);
    constrain(predicted_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::solidImplicit::begin
(
    const groupNodal& force,
    const volScalarField& p
)
{
    const scalar time = p.time().value() - system_.deltaT();

    oldPressure_.reset
    (
        new volScalarField
        (
            IOobject
            (
                p.name(),
                nameOf(p.mesh().time()),
                p.mesh(),
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            p
        )
    );
    passes_.begin();
    volScalarField& last = oldPressure_();
    answerAcceleration(last);
    fillFilmCells(system_.geometry, last);
    setGradient();

    vectorField nodal;
    system_.walls.transpose(last.primitiveField(), nodal);
    groupNodal total;
    system_.objects.layout().toGroups(system_.fluidDensity*nodal, total);
    predict(time, total, force);
    velocity_.change() = predicted_;
}


void Foam::fsi::solidImplicit::solveMomentum(fvVectorMatrix& UEqn)
{
    volVectorField& U = const_cast<volVectorField&>(UEqn.psi());
    system_.fluid.constrain(UEqn);

    viscous_.solve(UEqn, U, predicted_, velocity_.change(), linkForce_);
    constrain(velocity_);
    contact(velocity_);
}


void Foam::fsi::solidImplicit::solvePressure
(
    volScalarField& p,
    surfaceScalarField& phiHbyA,
    const scalar rAU
)
{
    const interfaceGeometry& geometry = system_.geometry;
    tmp<fvScalarMatrix> pEqn(openLaplacian(geometry, p, rAU));

    // Walls' flux without the pressure
    const scalarField last
    (
        system_.walls.atWalls(oldPressure_().primitiveField())
    );
    vectorField oldPart;
    term_.velocity(last, oldPart);
    scalarField source(p.size());
    system_.walls.flux(oldPart - velocity_.surface(), source);
    subtractOutflow(phiHbyA, source);

    solveWithObjects
    (
        p, pEqn.ref(), source, term_, oldPressure_().primitiveField()
    );
    pEqn.clear();

    subtractGradient(geometry, p, rAU, phiHbyA);

    // Velocities of all nodes with the increment of the pressure
    groupNodal force;
    pressureForce(system_.walls.atWalls(p) - last, force);
    addResponse(system_.objects, force, velocity_.change());
}


void Foam::fsi::solidImplicit::correctVelocity
(
    volVectorField& U,
    const volVectorField& last,
    const volScalarField& p,
    const scalar rAU
)
{
    const tmp<volVectorField> tgradient(system_.fluid.openGradient(p));
    const vectorField& gradient = tgradient().primitiveField();
    const boolList& fluid = system_.geometry.fluidCell();
    const scalarField& V = U.mesh().V();
    vectorField change(U.size());
    vectorField source(U.size());
    forAll(source, celli)
    {
        const vector force
        (
            fluid[celli] ? last[celli] - gradient[celli] : vector(Zero)
        );
        change[celli] = rAU*force;
        source[celli] = V[celli]*force;
    }
    const vectorField before(U.primitiveField());
    const immersedFluid& f = system_.fluid;
    viscous_.addResponse(source, f.responseGuess(change, system_.viscosity), U);
    passes_.measure(fluid, before, U.primitiveField(), change);
}


bool Foam::fsi::solidImplicit::again(volScalarField& p, const volVectorField&)
{
    if (!passes_.more())
    {
        passes_.report(*system_.log);
        return false;
    }

    // The objects answer to the change of the load as in (5.9)
    volScalarField& start = oldPressure_();
    const scalarField last(system_.walls.atWalls(start.primitiveField()));
    const vectorField lastForce(gradientForce_);
    p.primitiveFieldRef() =
        passes_.next(start.primitiveField(), p.primitiveField());
    p.correctBoundaryConditions();
    start.primitiveFieldRef() = p.primitiveField();
    start.correctBoundaryConditions();
    setGradient();

    groupNodal load;
    pressureForce
    (
        system_.walls.atWalls(start.primitiveField()) - last,
        load
    );
    addRigidForce(system_, gradientForce_ - lastForce, load);
    addResponse(system_.objects, load, predicted_);
    constrain(predicted_);
    velocity_.change() = predicted_;
    return true;
}


void Foam::fsi::solidImplicit::end
(
    const volScalarField& p,
    const volVectorField&
)
{
    limitContact(velocity_);
    constrain(velocity_);

    vectorField nodal;
    system_.walls.transpose(p.primitiveField(), nodal);
    hydrodynamicForce_ =
        linkForce_ + gradientForce_ + system_.fluidDensity*nodal;

    groupNodal links;
    system_.objects.layout().toGroups(linkForce_, links);
    forAll(links, groupi)
    {
        system_.objects.groups()[groupi].keepLinkLoad(links[groupi]);
    }
}


// ************************************************************************* //
