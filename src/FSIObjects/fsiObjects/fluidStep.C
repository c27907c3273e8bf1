// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidStep.H"
#include "fieldChecks.H"
#include "openfoamMesh.H"
#include "outflowBalance.H"
#include "stockInput.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Exchange the values of two fields without a copy of those inside
static void exchange(surfaceScalarField& a, surfaceScalarField& b)
{
    scalarField& ofA = a.primitiveFieldRef();
    scalarField& ofB = b.primitiveFieldRef();
    scalarField kept;
    kept.transfer(ofA);
    ofA.transfer(ofB);
    ofB.transfer(kept);
    forAll(a.boundaryField(), patchi)
    {
        scalarField& patchOfA = a.boundaryFieldRef()[patchi];
        scalarField& patchOfB = b.boundaryFieldRef()[patchi];
        const scalarField last(patchOfA);
        patchOfA = patchOfB;
        patchOfB = last;
    }
}

} // End namespace fsi
} // End namespace Foam


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
    level_(p),
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
    if (objects_.coupling().hasFluid())
    {
        stockInput::checkFluid(U.mesh());
        fieldChecks::check(p, U, objects_.system());
    }
    objects_.setSolidVelocity(U_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fluidStep::momentum
(
    const surfaceScalarField& convectiveFlux,
    const volVectorField& gradP,
    const expectedChange& change,
    const flowSources& sources
)
{
    tmp<fvVectorMatrix> tUEqn
    (
        objects_.system().fluid.momentum
        (
            convectiveFlux,
            U_,
            viscosity_,
            gradP,
            objects_.driving().value()
        )
    );
    fvVectorMatrix& UEqn = tUEqn.ref();

    sources.apply(UEqn, U_);
    objects_.coupling().solveMomentum(UEqn, change);
    sources.correct(U_);
}


void Foam::fsi::fluidStep::setFlux
(
    tmp<surfaceScalarField>& convectiveFlux,
    const volVectorField& gradP
)
{
    tmp<surfaceScalarField> tnew
    (
        objects_.system().fluid.faceFlux
        (
            U_,
            gradP,
            objects_.coupling().lastPressure(p_),
            objects_.coupling().wallVelocity(),
            viscosity_
        )
    );
    if (&convectiveFlux() == &phi_)
    {
        // Further passes of Euler convect with the old one
        exchange(phi_, tnew.ref());
        convectiveFlux = tnew;
    }
    else
    {
        phi_ = tnew;
    }
}


void Foam::fsi::fluidStep::pressure
(
    const volVectorField& gradP,
    const flowSources& sources
)
{
    fsiSystem& system = objects_.system();
    const scalar rAU = system.fluid.rule().step();

    system.setGivenFlux(p_, U_, objects_.coupling().wallVelocity());
    if (p_.needReference())
    {
        balanceOutflow(phi_, U_, system.walls.givenFlux());
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
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fluidStep::advance(const flowSources& sources)
{
    level_.remove();
    objects_.system().fluid.rule().begin(U_, phi_);
    objects_.startStep(p_, U_);
    if (objects_.coupling().hasFluid())
    {
        const stepTimer::section fluid
        (
            objects_.timer(),
            stepTimer::part::fluid
        );
        immersedFluid& immersed = objects_.system().fluid;
        tmp<surfaceScalarField> tconvective
        (
            immersed.firstConvectiveFlux(phi_)
        );
        expectedChange change
        (
            objects_.error().rate(), U_.time().deltaTValue()
        );
        bool more = true;
        while (more)
        {
            const tmp<volVectorField> tgradP(objects_.coupling().gradient(p_));
            momentum(tconvective(), tgradP(), change, sources);
            change = expectedChange();
            setFlux(tconvective, tgradP());
            pressure(tgradP(), sources);
            const bool counts = !objects_.coupling().refused();
            more = objects_.coupling().again(p_, U_);
            if (more && counts && immersed.rule().secondOrder())
            {
                tconvective = immersed.furtherConvectiveFlux(phi_);
            }
        }

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
    level_.set();
}


// ************************************************************************* //
