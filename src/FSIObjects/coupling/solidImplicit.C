// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidImplicit.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "filmPressure.H"
#include "objectResponse.H"
#include "openfoamVersion.H"
#include "openLaplacian.H"
#include "sharedPrediction.H"
#include "sumOverRanks.H"

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
    pressure_(system),
    sudden_(system),
    passes_(dict),
    balance_(system)
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
    addNetForce(system_, gradientForce_ + balance_.payment(), load);
    groupNodal rest(load.size());
    forAll(rest, groupi)
    {
        rest[groupi] = system_.objects.groups()[groupi].splitLoad(load[groupi]);
        load[groupi] += force[groupi];
    }
    predictShared(system_.objects, time, system_.stepTime(), load, predicted_);
    addResponse(system_.objects, rest, predicted_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::solidImplicit::begin
(
    const groupNodal& force,
    const volScalarField& p
)
{
    const scalar time = p.time().value() - system_.deltaT();
    balance_.pay();

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


void Foam::fsi::solidImplicit::solveMomentum
(
    fvVectorMatrix& UEqn,
    const expectedChange& change
)
{
    volVectorField& U = const_cast<volVectorField&>(UEqn.psi());
    system_.fluid.constrain(UEqn);
    if (countsLayer())
    {
        balance_.begin(U);
    }

    viscous_.solve(UEqn, U, change, predicted_, velocity_.change(), linkForce_);
    constrain(velocity_);
    contact(velocity_);
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
    p.primitiveFieldRef() = passes_.next
    (
        start.primitiveField(),
        p.primitiveField(),
        p.needReference(),
        system_.geometry.activeCell()
    );
    p.correctBoundaryConditions();
    start.primitiveFieldRef() = p.primitiveField();
    start.correctBoundaryConditions();
    setGradient();

    groupNodal load;
    pressureForce
    (
        system_.walls.atWalls(start.primitiveField()) - last, load
    );
    addNetForce(system_, gradientForce_ - lastForce, load);
    addResponse(system_.objects, load, predicted_);
    velocity_.change() = predicted_;
    return true;
}


void Foam::fsi::solidImplicit::settle(const volVectorField& U)
{
    vectorField force(gradientForce_.size(), Zero);
    system_.fluid.cut().addLoss
    (
        *system_.levelSet, system_.surfaces(), U, velocity_.surface(), force
    );
    sumOverRanks(force);
    force *= system_.fluidDensity;
    vectorField links;
    viscous_.linkForceBeyond(U, links);
    balance_.owe(force + links + newGradientForce_ - gradientForce_);
}


void Foam::fsi::solidImplicit::renew()
{
    couplingModel::renew();
    balance_.renew();
}


bool Foam::fsi::solidImplicit::countsLayer() const
{
    return !system_.fluid.rule().secondOrder();
}


void Foam::fsi::solidImplicit::beginMove(const volVectorField& U)
{
    if (countsLayer())
    {
        balance_.beginMove(U);
    }
}


void Foam::fsi::solidImplicit::endMove(const volVectorField& U)
{
    if (countsLayer())
    {
        balance_.endMove(U);
        hydrodynamicForce_ += balance_.close();
    }
}


void Foam::fsi::solidImplicit::end
(
    const volScalarField& p,
    const volVectorField& U
)
{
    pressure_.endStep(p);
    settle(U);
    limitContact(velocity_);
    constrain(velocity_);

    vectorField nodal;
    system_.walls.transpose(p.primitiveField(), nodal);
    nodal = linkForce_ + system_.fluidDensity*nodal;
    hydrodynamicForce_ = nodal + gradientForce_;
    if (!countsLayer())
    {
        hydrodynamicForce_ += balance_.close();
    }

    groupNodal load;
    system_.objects.layout().toGroups(nodal, load);
    addNetForce(system_, gradientForce_ + balance_.payment(), load);
    forAll(load, groupi)
    {
        system_.objects.groups()[groupi].keepLoad(load[groupi]);
    }
}


// ************************************************************************* //
