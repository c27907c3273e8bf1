// SPDX-License-Identifier: GPL-3.0-or-later

#include "weakStep.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "findRefCell.H"
#include "fluidRegions.H"
#include "fvMatrices.H"
#include "openfoamMesh.H"
#include "openLaplacian.H"
#include "stepControls.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(weakStep, 0);
    addToRunTimeSelectionTable(fsiStep, weakStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::weakStep::weakStep
(
    fsiObjects& objects,
    const flowFields& flow,
    const dictionary& dict
)
:
    fluidStep(objects, flow),
    load_(hydrodynamicLoad::New(*this, dict)),
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
    if (flow.law)
    {
        FatalIOErrorInFunction(objects.properties())
            << "Coupling " << type() << " is for Newtonian fluids, but the"
            << " viscosity is of the model " << flow.law->name() << ": take the"
            << " coupling solidImplicit" << exit(FatalIOError);
    }
    if (rule_.secondOrder() && objects.bodies().size())
    {
        FatalIOErrorInFunction(objects.properties())
            << "Coupling " << type() << " is of first order in time, since the"
            << " fluid sees the walls of the last step: take Euler for"
            << " ddtSchemes, or the coupling solidImplicit or none"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::weakStep::solveMomentum
(
    const surfaceScalarField& convectiveFlux,
    const volVectorField& gradP,
    const flowSources& sources
)
{
    tmp<fvVectorMatrix> tUEqn(momentum(convectiveFlux, gradP, sources));
    fvVectorMatrix& UEqn = tUEqn.ref();
    for (const wallLink& link : geometry_.wallLinks())
    {
        const scalar g = objects_.fluid().viscosity*link.conductance;
        UEqn.diag()[link.cell] += g;
        UEqn.source()[link.cell] += g*link.place.interpolate(wallVelocity_);
    }
    UEqn.solve(solverControls(U_.mesh(), U_.name()));
    sources.correct(U_);
}


void Foam::fsi::weakStep::fixInactive(fvScalarMatrix& pEqn) const
{
    const boolList& active = geometry_.activeCell();
    const scalar diagonal =
        max(overRanks(max(pEqn.diag()), maxOp<scalar>()), SMALL);

    forAll(active, celli)
    {
        if (!active[celli])
        {
            pEqn.diag()[celli] = diagonal;
            pEqn.source()[celli] = diagonal*p_[celli];
        }
    }
}


void Foam::fsi::weakStep::solvePressureEquation(fvScalarMatrix& pEqn)
{
    fixInactive(pEqn);
    dictionary controls(stepControls(p_.mesh()));
    if (!controls.found("pRefCell") && !controls.found("pRefPoint"))
    {
        // The first cell; the first ranks may have none
        const label rank = p_.size() ? rankIn() : labelMax;
        const label first = overRanks(rank, minOp<label>());
        if (first == 0)
        {
            controls.add("pRefCell", 0);
        }
        else
        {
            const point mine
            (
                rank == first ? p_.mesh().C()[0] : point::uniform(-GREAT)
            );
            controls.add("pRefPoint", overRanks(mine, maxOp<point>()));
        }
    }
    controls.add("pRefValue", 0, false);
    label cell = -1;
    scalar value = 0;
    setRefCell(p_, controls, cell, value);
    pEqn.setReference(cell, value);
    pEqn.solve(solverControls(p_.mesh(), p_.name()));
}


void Foam::fsi::weakStep::solvePressure
(
    const volVectorField& gradP,
    const flowSources& sources
)
{
    const scalar dt = rule_.length().tau;
    const scalar nu = objects_.fluid().viscosity;
    setGivenFlux(wallVelocity_);
    {
        const stepTimer::section pressure
        (
            objects_.timer(), stepTimer::part::pressure
        );
        tmp<fvScalarMatrix> tpEqn(openLaplacian(geometry_, p_, dt, nu));
        fvScalarMatrix& pEqn = tpEqn.ref();

        walls_.flux(wallVelocity_, pEqn.source());
        walls_.addGivenFlux(pEqn.source());
        pEqn.source().negate();
        subtractOutflow(phi_, pEqn.source());
        fluidRegions(geometry_, p_).removeNetSource(pEqn.source());

        solvePressureEquation(pEqn);
        subtractGradient(geometry_, p_, dt, nu, phi_);
    }
    gradients_.correctVelocity
    (
        U_, gradP, p_, dt, nu
    );
    sources.correct(U_);
}


void Foam::fsi::weakStep::relax(const vectorField& residual)
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


bool Foam::fsi::weakStep::passAgain(const stepLength& step)
{
    ++pass_;
    load_->calculate(p_, U_, wallVelocity_, hydrodynamicForce_);
    groupNodal total;
    objects_.bodies().layout().toGroups(hydrodynamicForce_, total);
    nodeLayout::add(force_, total);
    predictAlone(total, step);
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::weakStep::advance(const flowSources& sources)
{
    begin();
    const stepLength step(rule_.length());
    force_ = objects_.forces(step);
    addOutsidePressure(force_);
    velocity_.reset();
    wallVelocity_ = objects_.bodies().surfaces().velocities();
    pass_ = 0;

    {
        const stepTimer::section fluid
        (
            objects_.timer(), stepTimer::part::fluid
        );
        tmp<surfaceScalarField> flux(moved(rule_.flux(phi_)));
        do
        {
            const tmp<volVectorField> gradP(gradients_.gradient(p_));
            solveMomentum(flux(), gradP(), sources);
            setFlux(flux, p_, gradP(), wallVelocity_);
            solvePressure(gradP(), sources);
        }
        while (passAgain(step));
    }

    finishFluid(wallVelocity_, 0);
    objects_.limit(velocity_, step);
    objects_.constrain(velocity_, step);
    objects_.move(velocity_.groups(), step);
    beginMove({});
    endMove();
    endStep();
}


// ************************************************************************* //
