// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidImplicit.H"
#include "globalMeshData.H"
#include "largestSpeed.H"
#include "objectResponse.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::solidImplicit::answerAcceleration(volScalarField& last)
{
    if (!sudden_.update(last))
    {
        return;
    }
    const scalarField before(last.primitiveField());
    tmp<fvScalarMatrix> pEqn
    (
        openLaplacian(system_.geometry, last, system_.deltaT())
    );
    scalarField source;
    sudden_.setSource(last, source);
    pressure_.solve(last, pEqn.ref(), source, sudden_, before);
    expectPressure(system_, last.primitiveField() - before);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    system_.walls.flux(velocity_.surface() - oldPart, source);
    system_.walls.addGivenFlux(source);
    source.negate();
    subtractOutflow(phiHbyA, source);

    if (passes_.done() == 0)
    {
        pressure_.beginStep(p);
    }
    pressure_.solve
    (
        p, pEqn.ref(), source, term_, oldPressure_().primitiveField()
    );
    pEqn.clear();

    subtractGradient(geometry, p, rAU, phiHbyA);
    system_.fluid.cut().end(phiHbyA);

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
    tmp<volVectorField> tgradient(system_.fluid.openGradient(p));
    system_.walls.gradientForce(tgradient(), newGradientForce_);
    newGradientForce_ *= system_.fluidDensity;
    const vectorField& gradient = tgradient().primitiveField();
    const boolList& fluid = system_.geometry.fluidCell();
    const scalar V = system_.grid.faceArea()*system_.grid.spacing();
    vectorField source(U.size());
    forAll(source, celli)
    {
        source[celli] =
            fluid[celli] ? V*(last[celli] - gradient[celli]) : vector(Zero);
    }
    tgradient.clear();
    const scalar alone = rAU/V;
    passes_.measure
    (
        viscous_.addResponse
        (
            source,
            system_.fluid.responseGuess(source, alone, system_.viscosity),
            alone,
            U
        ),
        U.mesh().globalData().nTotalCells()*sqr(system_.restSpeed()),
        largestSpeed(velocity_.change()),
        largestSpeed(U, fluid)
    );
}


// ************************************************************************* //
