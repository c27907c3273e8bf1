// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "modelSources.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace solvers
{
    defineTypeNameAndDebug(fsiFluid, 0);
    addToRunTimeSelectionTable(solver, fsiFluid, fvMesh);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::solvers::fsiFluid::viscosityOfFluid() const
{
    const tmp<volScalarField> tnu(viscosity->nu());
    const scalar low = gMin(tnu().primitiveField());
    const scalar high = gMax(tnu().primitiveField());
    if (!(low > 0) || high > low)
    {
        FatalErrorInFunction
            << "The viscosity of constant/physicalProperties is from " << low
            << " to " << high << " m2/s but must be > 0 and the same in all of"
            << " the fluid: take  viscosityModel constant;" << exit(FatalError);
    }
    return high;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solvers::fsiFluid::fsiFluid(fvMesh& mesh)
:
    incompressibleFluid(mesh),
    lock_(mesh.time().globalPath()),
    nu_(viscosityOfFluid()),
    objects_(mesh, nu_),
    step_(fsi::fsiStep::New(objects_, {p_, U_, phi_})),
    timeStep_(mesh.time()),
    nextDeltaT_(mesh.time().deltaTValue())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::solvers::fsiFluid::maxDeltaT() const
{
    return min(nextDeltaT_, fvModels().maxDeltaT());
}


void Foam::solvers::fsiFluid::preSolve()
{
    incompressibleFluid::preSolve();
    nextDeltaT_ = timeStep_.next(phi_, *step_);
}


void Foam::solvers::fsiFluid::prePredictor()
{}


void Foam::solvers::fsiFluid::momentumPredictor()
{
    if (!pimple.firstIter())
    {
        FatalIOErrorInFunction(pimple.dict())
            << "Entry 'nOuterCorrectors' must be 1: the step of fsiFluid has"
            << " its own passes" << exit(FatalIOError);
    }
    step_->advance(fsi::modelSources(fvModels(), fvConstraints()));
}


void Foam::solvers::fsiFluid::pressureCorrector()
{}


void Foam::solvers::fsiFluid::postSolve()
{
    timeStep_.write();
    step_->write();
    if (!mesh.time().running())
    {
        step_->summary(Info);
    }
}


// ************************************************************************* //
