// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidStep.H"
#include "openfoamMesh.H"
#include "adjustPhi.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fluidStep::fluidStep
(
    fsiObjects& objects,
    volScalarField& p,
    volVectorField& U,
    surfaceScalarField& phi,
    const scalar viscosity
)
:
    objects_(objects),
    p_(p),
    U_(U),
    phi_(phi),
    viscosity_(viscosity)
{
    const word timeScheme(ddtSchemeOf(U.mesh(), "ddt(U)"));
    if (timeScheme != "Euler" && timeScheme != "backward")
    {
        FatalIOErrorInFunction(schemesOf(U.mesh()))
            << "Entry 'ddt(U)' or 'default' of ddtSchemes is " << timeScheme
            << " but must be Euler or backward"
            << exit(FatalIOError);
    }
    immersedMomentum::interpolation(phi);
    objects_.setSolidVelocity(U_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fluidStep::momentum
(
    const volVectorField& gradP,
    const flowSources& sources
)
{
    tmp<fvVectorMatrix> tUEqn
    (
        objects_.system().fluid.momentum
        (
            phi_,
            U_,
            viscosity_,
            gradP,
            objects_.driving().value()
        )
    );
    fvVectorMatrix& UEqn = tUEqn.ref();

    sources.apply(UEqn, U_);
    objects_.coupling().solveMomentum(UEqn);
    sources.correct(U_);
}


void Foam::fsi::fluidStep::pressure
(
    const volVectorField& gradP,
    const flowSources& sources
)
{
    timeRule& rule = objects_.system().fluid.rule();
    const scalar rAU = rule.step();

    phi_ = objects_.system().fluid.faceFlux
    (
        U_,
        gradP,
        objects_.coupling().lastPressure(p_),
        objects_.coupling().wallVelocity(),
        viscosity_
    );
    if (p_.needReference())
    {
        adjustPhi(phi_, U_, p_);
    }
    {
        const stepTimer::section pressure
        (
            objects_.timer(),
            stepTimer::part::pressure
        );
        objects_.coupling().solvePressure(p_, phi_, rAU);
    }
    objects_.coupling().correctVelocity(U_, gradP, p_, rAU);
    sources.correct(U_);

    // The flux is that of the new time now, also in a further pass
    rule.nextPass();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fluidStep::advance(const flowSources& sources)
{
    objects_.system().fluid.rule().begin(U_, phi_);
    objects_.startStep(p_, U_);
    if (objects_.coupling().hasFluid())
    {
        const stepTimer::section fluid
        (
            objects_.timer(),
            stepTimer::part::fluid
        );
        do
        {
            const tmp<volVectorField> tgradP(objects_.coupling().gradient(p_));
            momentum(tgradP(), sources);
            pressure(tgradP(), sources);
        }
        while (objects_.coupling().again(p_, U_));

        objects_.system().fluid.storeFaceVelocity
        (
            phi_,
            U_,
            objects_.coupling().wallVelocity(),
            viscosity_
        );
    }
    objects_.finishStep(p_, U_);
    objects_.system().fluid.moveFlux(phi_);
}


// ************************************************************************* //
