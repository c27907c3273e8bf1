// SPDX-License-Identifier: GPL-3.0-or-later

#include "weakCoupling.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "fluidRegions.H"
#include "openfoamMesh.H"
#include "openLaplacian.H"
#include "sharedPrediction.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(weakCoupling, 0);
    addToRunTimeSelectionTable(couplingModel, weakCoupling, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::weakCoupling::weakCoupling
(
    fsiSystem& system,
    stepTimer& timer,
    const dictionary& dict
)
:
    couplingModel(system, timer, dict),
    load_(hydrodynamicLoad::New(system, dict)),
    subIterations_(label(readPositive(dict, "subIterations", 1))),
    tolerance_(readPositive(dict, "tolerance", 1e-3)),
    firstRelaxation_(readPositive(dict, "relaxation", 0.5)),
    pass_(0),
    relaxation_(firstRelaxation_)
{
    checkKeys
    (
        dict,
        {"type", "load", "subIterations", "tolerance", "relaxation"}
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::weakCoupling::predict
(
    const volScalarField& p,
    const volVectorField& U
)
{
    const scalar dt = system_.deltaT();
    const scalar time = p.time().value() - dt;

    load_->calculate(p, U, wallVelocity_, hydrodynamicForce_);
    groupNodal total;
    system_.objects.layout().toGroups(hydrodynamicForce_, total);
    forAll(total, groupi)
    {
        total[groupi] += force_[groupi];
    }
    predictShared(system_.objects, time, dt, total, velocity_.change());
    constrain(velocity_);
    contact(velocity_);
    constrain(velocity_);
}


void Foam::fsi::weakCoupling::relax(const vectorField& residual)
{
    if (pass_ == 1)
    {
        relaxation_ = firstRelaxation_;
    }
    else
    {
        const vectorField change(residual - residual_);
        relaxation_ *=
            -sum(residual_ & change)/max(sum(magSqr(change)), VSMALL);
    }
    residual_ = residual;
    wallVelocity_ += relaxation_*residual;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::weakCoupling::begin
(
    const groupNodal& force,
    const volScalarField&
)
{
    pass_ = 0;
    force_ = force;
    velocity_.reset();
    wallVelocity_ = system_.objects.surfaces().velocities();
}


void Foam::fsi::weakCoupling::solveMomentum
(
    fvVectorMatrix& UEqn,
    const expectedChange&
)
{
    system_.fluid.constrain(UEqn);
    for (const wallLink& link : system_.geometry.wallLinks())
    {
        const scalar g = system_.viscosity*link.conductance;
        UEqn.diag()[link.cell] += g;
        UEqn.source()[link.cell] +=
            g*link.place.interpolate(wallVelocity_);
    }
    UEqn.solve(solverControls(UEqn.psi().mesh(), UEqn.psi().name()));
}


void Foam::fsi::weakCoupling::solvePressure
(
    volScalarField& p,
    surfaceScalarField& phiHbyA,
    const scalar rAU
)
{
    tmp<fvScalarMatrix> tpEqn(openLaplacian(system_.geometry, p, rAU));
    fvScalarMatrix& pEqn = tpEqn.ref();

    system_.walls.flux(wallVelocity_, pEqn.source());
    system_.walls.addGivenFlux(pEqn.source());
    pEqn.source().negate();
    subtractOutflow(phiHbyA, pEqn.source());
    fluidRegions(system_.geometry, p).removeNetSource(pEqn.source());

    solveFluidPressure(p, pEqn);
    subtractGradient(system_.geometry, p, rAU, phiHbyA);
}


bool Foam::fsi::weakCoupling::again
(
    volScalarField& p,
    const volVectorField& U
)
{
    ++pass_;
    predict(p, U);
    if (pass_ >= subIterations_)
    {
        return false;
    }

    const vectorField& objectVelocity = velocity_.surface();
    const vectorField residual(objectVelocity - wallVelocity_);
    const scalar scale = max(max(magSqr(objectVelocity)), VSMALL);
    if (max(magSqr(residual)) < sqr(tolerance_)*scale)
    {
        return false;
    }
    relax(residual);
    return true;
}


void Foam::fsi::weakCoupling::end
(
    const volScalarField&,
    const volVectorField&
)
{
    limitContact(velocity_);
    constrain(velocity_);
}


// ************************************************************************* //
