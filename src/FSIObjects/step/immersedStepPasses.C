// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedStep.H"
#include "globalMeshData.H"
#include "largestSpeed.H"
#include "objectResponse.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedStep::solveMomentum
(
    const surfaceScalarField& convectiveFlux,
    const expectedChange& change,
    const flowSources& sources
)
{
    tmp<fvVectorMatrix> UEqn(momentum(convectiveFlux, gradient_(), sources));
    geometry_.setWallVelocities(U_);
    membranes_.addTo(UEqn.ref());
    profiles_.setForce(oldPressure_(), step().tau);
    viscous_.solve
    (
        UEqn.ref(), U_, step(), change, predicted_, profiles_.force(),
        velocity_.change(), linkForce_
    );
    sources.correct(U_);
}


void Foam::fsi::immersedStep::solvePressure()
{
    setGivenFlux(velocity_.surface());
    const stepTimer::section pressure
    (
        objects_.timer(), stepTimer::part::pressure
    );
    const scalar nu = objects_.fluid().viscosity;
    tmp<fvScalarMatrix> pEqn(openLaplacian(geometry_, p_, step().tau, nu));

    // Flux of walls and films without the pressure
    const scalarField last(walls_.atWalls(oldPressure_().primitiveField()));
    vectorField before;
    term_.velocity(last, before);
    scalarField source(p_.size());
    walls_.flux(velocity_.surface(), source, &before);
    walls_.addGivenFlux(source);
    source.negate();
    subtractOutflow(phi_, source);

    if (passes_.done() == 0)
    {
        pressure_.beginStep(p_);
    }
    pressure_.solve
    (
        p_,
        pEqn.ref(),
        source,
        objects_.bodies().onlyMembranes() ? nullptr : &term_,
        oldPressure_().primitiveField(),
        &U_.primitiveField(),
        step()
    );
    pEqn.clear();

    subtractGradient(geometry_, p_, step().tau, nu, phi_);

    // All nodes move with the increment of the pressure, and films with them
    before = velocity_.surface();
    const groupNodal load(pressureForce(walls_.atWalls(p_) - last, true));
    addResponse(objects_.bodies(), load, velocity_.change());
    walls_.inFilms().addFaceFlux(velocity_.surface() - before, phi_);
    momentum_.cut().end(phi_);
}


void Foam::fsi::immersedStep::correctVelocity(const flowSources& sources)
{
    tmp<volVectorField> tgradient(gradients_.openGradient(p_));
    walls_.gradientForce(tgradient(), newGradientForce_);
    newGradientForce_ *= objects_.fluid().density;
    const vectorField& gradient = tgradient().primitiveField();
    const vectorField& last = gradient_().primitiveField();
    const boolList& inFluid = geometry_.fluidCell();
    if (passes_.single() && objects_.bodies().onlyMembranes())
    {
        vectorField& u = U_.primitiveFieldRef();
        forAll(u, celli)
        {
            u[celli] += step().tau*(last[celli] - gradient[celli]);
        }
        U_.correctBoundaryConditions();
        passes_.end();
        sources.correct(U_);
        return;
    }
    const scalar V = objects_.grid().cellVolume();
    vectorField source(U_.size());
    forAll(source, celli)
    {
        source[celli] =
            inFluid[celli] ? V*(last[celli] - gradient[celli]) : vector(Zero);
    }
    tgradient.clear();
    const scalar alone = step().tau/V;
    vectorField guess;
    if (rule_.secondOrder())
    {
        const scalar nu = objects_.fluid().viscosity;
        guess = alone*source/(1 + step().tau*gradients_.wallFriction(nu));
    }
    passes_.measure
    (
        viscous_.addResponse(source, guess, alone, U_),
        U_.mesh().globalData().nTotalCells()*sqr(objects_.restSpeed()),
        velocity_.groups(),
        largestSpeed(U_, inFluid),
        objects_.contact().acts()
    );
    sources.correct(U_);
}


bool Foam::fsi::immersedStep::passAgain
(
    tmp<surfaceScalarField>& convectiveFlux
)
{
    const stepTimer::section fluid(objects_.timer(), stepTimer::part::fluid);
    if (!passes_.more())
    {
        passes_.report(objects_.log());
        return false;
    }
    if (rule_.secondOrder() && !passes_.refused())
    {
        convectiveFlux = moved(tmp<surfaceScalarField>(phi_));
    }

    // The objects answer to the change of the load as in (5.9)
    volScalarField& start = oldPressure_();
    const scalarField last(walls_.atWalls(start.primitiveField()));
    const vectorField lastForce(gradientForce_);
    p_.primitiveFieldRef() = passes_.next
    (
        start.primitiveField(), p_.primitiveField(), p_.needReference(),
        geometry_.activeCell()
    );
    profiles_.next(passes_, velocity_.surface());
    p_.correctBoundaryConditions();
    start.primitiveFieldRef() = p_.primitiveField();
    start.correctBoundaryConditions();
    setGradient();

    groupNodal load
    (
        pressureForce(walls_.atWalls(start.primitiveField()) - last)
    );
    addNetForce(objects_.bodies(), gradientForce_ - lastForce, load);
    addResponse(objects_.bodies(), load, predicted_);
    objects_.contact().carry().next(passes_.refused(), predicted_);
    velocity_.change() = predicted_;
    return true;
}


// ************************************************************************* //
