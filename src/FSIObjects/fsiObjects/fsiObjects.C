// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjects.H"
#include "dictionaryCheck.H"
#include "motionCheck.H"
#include "newCells.H"
#include "objectContact.H"
#include "openfoamVersion.H"
#include "projectVersion.H"
#include "restartFiles.H"
#include "OStringStream.H"
#include "secondOrderStep.H"
#include "userVariables.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Check the keys of fsiProperties before anything is read from it
static const dictionary& checked(const dictionary& dict)
{
    userVariables::checkFileKeys
    (
        dict,
        {
            "fluidDensity", "gravity", "wall", "minWallDistance",
            "shortWaveStress", "levelSet", "coupling", "contact",
            "boundaries", "drivingForce", "output"
        },
        {"convection", "faceHistory", "transposedStress"}
    );
    checkSubDicts
    (
        dict,
        {
            "levelSet", "coupling", "contact", "boundaries", "drivingForce",
            "output"
        }
    );
    return dict;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fsiObjects::fsiObjects
(
    const fvMesh& mesh,
    const scalar viscosity,
    const couplingSelector& select
)
:
    mesh_(mesh),
    properties_
    (
        IOobject
        (
            "fsiProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    system_(mesh, checked(properties_), viscosity),
    boundaries_(system_.grid, system_.sides, system_.objects, properties_),
    coupling_(select(system_, timer_)),
    writer_
    (
        mesh.time(),
        properties_.subOrEmptyDict("output"),
        system_.grid.nDims()
    ),
    timeError_(mesh),
    signedDistance_
    (
        IOobject
        (
            "signedDistance",
            nameOf(mesh.time()),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimLength, Zero)
    ),
    objectLabel_
    (
        IOobject
        (
            "objectLabel",
            nameOf(mesh.time()),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar("value", dimless, -1)
    )
{
    restartFiles::check(mesh);
    Info<< "FSIObjects " << projectVersion << ": "
        << system_.objects.size() << " objects, "
        << system_.objects.nNodes() << " nodes, coupling "
        << coupling_->type() << ", wall " << system_.wall->type()
        << ", level set " << system_.levelSet->type() << nl << endl;
    checkMotion();
    const motionCheck check(system_.objects, mesh_.time());
    check.checkOverlaps(system_.sides.period());
    if (coupling_->hasFluid() && system_.driving->type() == "none")
    {
        check.checkWeight
        (
            mesh_.boundaryMesh(), system_.sides.period(), system_.gravity,
            system_.fluidDensity
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fsiObjects::checkMotion() const
{
    const motionCheck check(system_.objects, mesh_.time());
    check.checkSpeeds(system_.grid.bounds().span(), system_.grid.spacing());
    check.checkElements();
    check.checkPrescribed(system_.sides.period());
}


void Foam::fsi::fsiObjects::updateWalls(volScalarField& p, volVectorField& U)
{
    const vectorField& v = system_.objects.surfaces().velocities();
    coupling_->beginMove(U);
    if (coupling_->hasFluid())
    {
        system_.fluid.beginMove(U, v);
    }
    {
        const stepTimer::section levelSet(timer_, stepTimer::part::levelSet);
        system_.levelSet->move(system_.surfaces(), system_.deltaT());
    }
    const stepTimer::section coupling(timer_, stepTimer::part::coupling);
    if (coupling_->hasFluid())
    {
        const boolList wasActive(system_.geometry.activeCell());
        system_.updateGeometry();
        coupling_->endMove(U);
        fillNewCells(wasActive, system_.geometry.activeCell(), p);
        setSolidVelocity(U);
        system_.fluid.endMove(U, v, system_.viscosity);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fsiObjects::startStep
(
    volScalarField& p,
    volVectorField& U
)
{
    checkCrossing();
    const stepTimer::section solids(timer_, stepTimer::part::solids);
    if (boundaries_.update(mesh_.time().value() - system_.deltaT()))
    {
        const stepTimer::section levelSet(timer_, stepTimer::part::levelSet);
        system_.renew();
        coupling_->renew();
    }
    system_.driving->update(U, system_.objects, system_.fluidDensity);
    if (system_.log->full())
    {
        system_.driving->log(Info);
    }

    if (system_.fluid.rule().secondOrder())
    {
        beginSecondOrder(system_, *coupling_);
        updateWalls(p, U);
    }

    fsiSystem::groupNodal force;
    system_.objects.layout().zero(force);
    system_.addBodyForce(force);
    if (coupling_->hasFluid())
    {
        system_.addOutsidePressure(p, force);
    }
    for (bodyGroup& group : system_.objects.groups())
    {
        group.prepareResponse(system_.stepTime());
    }
    {
        const stepTimer::section contact(timer_, stepTimer::part::contact);
        system_.contacts->addForce(force);
    }
    coupling_->begin(force, p);
}


void Foam::fsi::fsiObjects::finishStep(volScalarField& p, volVectorField& U)
{
    if (coupling_->hasFluid())
    {
        timeError_.measure
        (
            U,
            system_.geometry.fluidCell(),
            coupling_->splittingError(),
            system_.restSpeed()
        );
    }
    coupling_->end(p, U);
    {
        const stepTimer::section solids(timer_, stepTimer::part::solids);
        forAll(system_.objects.groups(), groupi)
        {
            system_.objects.groups()[groupi].move
            (
                system_.stepTime(),
                coupling_->velocity()[groupi]
            );
        }
        system_.updateSurfaces();
        checkMotion();
    }
    {
        const stepTimer::section contact(timer_, stepTimer::part::contact);
        system_.contacts->measure();
    }
    updateWalls(p, U);
}


void Foam::fsi::fsiObjects::setSolidVelocity(volVectorField& U) const
{
    system_.fluid.setSolidVelocity
    (
        U,
        system_.surfaces(),
        *system_.levelSet
    );
}


Foam::scalar Foam::fsi::fsiObjects::courantNo() const
{
    scalar largest = 0;
    for (const vector& v : system_.objects.surfaces().velocities())
    {
        largest = max(largest, cmptMax(cmptMag(v)));
    }
    return largest*system_.deltaT()/system_.grid.spacing();
}


Foam::string Foam::fsi::fsiObjects::fastest() const
{
    const surfaceSet& surfaces = system_.objects.surfaces();
    if (surfaces.velocities().empty())
    {
        return "";
    }
    const label nodei = findMax(mag(surfaces.velocities())());
    OStringStream os;
    os  << ": object "
        << system_.objects.objectId(surfaces.pointObject()[nodei])
        << " moves at " << mag(surfaces.velocities()[nodei]) << " m/s";
    return os.str();
}


// ************************************************************************* //
