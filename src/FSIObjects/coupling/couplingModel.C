// SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingModel.H"
#include "findRefCell.H"
#include "objectContact.H"
#include "openfoamMesh.H"
#include "stepControls.H"
#include "selection.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(couplingModel, 0);
    defineRunTimeSelectionTable(couplingModel, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::couplingModel::couplingModel
(
    fsiSystem& system,
    stepTimer& timer,
    const dictionary&
)
:
    system_(system),
    timer_(timer),
    velocity_(system.objects.layout()),
    hydrodynamicForce_(system.objects.surfaces().points().size(), Zero)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::couplingModel> Foam::fsi::couplingModel::New
(
    fsiSystem& system,
    stepTimer& timer
)
{
    const dictionary& dict = system.properties.subOrEmptyDict("coupling");
    const word type(dict.lookupOrDefault<word>("type", "solidImplicit"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, system.properties, "coupling", type
    )(system, timer, dict);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::fsi::couplingModel::constrain(groupNodal& v) const
{
    forAll(v, groupi)
    {
        system_.objects.groups()[groupi].constrain
        (
            system_.stepTime(),
            v[groupi]
        );
    }
}


void Foam::fsi::couplingModel::contact(nodeVelocities& v) const
{
    const stepTimer::section section(timer_, stepTimer::part::contact);
    system_.contacts->push(v);
}


void Foam::fsi::couplingModel::limitContact(nodeVelocities& v) const
{
    const stepTimer::section section(timer_, stepTimer::part::contact);
    system_.contacts->limit(v);
}


void Foam::fsi::couplingModel::fixInactive
(
    const volScalarField& p,
    fvScalarMatrix& pEqn
) const
{
    const boolList& active = system_.geometry.activeCell();
    const scalar diagonal =
        max(overRanks(max(pEqn.diag()), maxOp<scalar>()), SMALL);

    forAll(active, celli)
    {
        if (!active[celli])
        {
            pEqn.diag()[celli] = diagonal;
            pEqn.source()[celli] = diagonal*p[celli];
        }
    }
}


void Foam::fsi::couplingModel::solveFluidPressure
(
    volScalarField& p,
    fvScalarMatrix& pEqn
) const
{
    fixInactive(p, pEqn);
    dictionary controls(stepControls(p.mesh()));
    if (!controls.found("pRefCell") && !controls.found("pRefPoint"))
    {
        // The first cell; the first ranks may have none
        const label rank = p.size() ? rankIn() : labelMax;
        const label first = overRanks(rank, minOp<label>());
        if (first == 0)
        {
            controls.add("pRefCell", 0);
        }
        else
        {
            const point mine
            (
                rank == first ? p.mesh().C()[0] : point::uniform(-GREAT)
            );
            controls.add("pRefPoint", overRanks(mine, maxOp<point>()));
        }
    }
    controls.add("pRefValue", 0, false);
    label cell = -1;
    scalar value = 0;
    setRefCell(p, controls, cell, value);
    pEqn.setReference(cell, value);
    pEqn.solve(solverControls(p.mesh(), p.name()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::couplingModel::renew()
{
    velocity_.reset();
    hydrodynamicForce_.setSize(system_.objects.layout().nSurface());
    hydrodynamicForce_ = Zero;
}


void Foam::fsi::couplingModel::correctVelocity
(
    volVectorField& U,
    const volVectorField& last,
    const volScalarField& p,
    const scalar rAU
)
{
    system_.fluid.correctVelocity(U, last, p, rAU, system_.viscosity);
}


// ************************************************************************* //
