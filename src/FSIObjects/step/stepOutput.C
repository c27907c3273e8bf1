// SPDX-License-Identifier: GPL-3.0-or-later

#include "stepOutput.H"
#include "IOmanip.H"
#include "meanFluidVelocity.H"
#include "objectStresses.H"
#include "openfoamMesh.H"
#include "restartFiles.H"
#include "sumOverRanks.H"
#include "surfaceTractions.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static IOobject writtenField(const fvMesh& mesh, const word& name)
{
    return IOobject
    (
        name,
        nameOf(mesh.time()),
        mesh,
        IOobject::NO_READ,
        IOobject::AUTO_WRITE
    );
}


//- Print a kind of work of the ranks, and how much more the largest has than
//  the mean
static void reportWork
(
    const char* name,
    const label work,
    Ostream& os
)
{
    const scalarList all(gatherOverRanks(scalar(work)));
    const scalar mean = sum(all)/all.size();
    os  << "    " << setw(10) << name << setw(14) << min(all) << setw(14)
        << max(all) << setw(14) << max(all)/max(mean, SMALL) << nl;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::stepOutput::stepOutput(fsiObjects& objects)
:
    objects_(objects),
    writer_
    (
        objects.grid().mesh().time(),
        objects.properties().subOrEmptyDict("output"),
        objects.grid().nDims()
    ),
    followed_(objects.grid().mesh().time(), objects.bodies()),
    signedDistance_
    (
        writtenField(objects.grid().mesh(), "signedDistance"),
        objects.grid().mesh(),
        dimensionedScalar(dimLength, Zero)
    ),
    objectLabel_
    (
        writtenField(objects.grid().mesh(), "objectLabel"),
        objects.grid().mesh(),
        dimensionedScalar("value", dimless, -1)
    )
{
    if (writer_.stressesWanted() || !objects.bodies().onlyMembranes())
    {
        objects_.contact().keepForces();
    }
    if (writer_.stressesWanted())
    {
        rheology_.reset(new rheology(objects_));
    }
    if (objects_.frame().active())
    {
        frame_ = objectWriter::newTable
        (
            objects.grid().mesh().time(),
            "frame",
            {
                "time", "velocityX", "velocityY", "velocityZ", "positionX",
                "positionY", "positionZ"
            }
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::stepOutput::report(const timeError& error)
{
    const fvMesh& mesh = objects_.grid().mesh();
    const Time& time = mesh.time();
    const levelSetUpdate& levelSet = objects_.levelSet();

    stepRecord record(stepRecord::sample(objects_.bodies()));
    record.time = time.value();
    record.deltaT = time.deltaTValue();
    record.removed = objects_.boundaries().nRemoved();
    record.fed = objects_.boundaries().nFed();
    record.fluidVelocity = meanFluidVelocity
    (
        mesh.lookupObject<volVectorField>("U"),
        levelSet,
        objects_.grid().haloIndex()
    );
    const contactStatistics& contacts = objects_.contact().statistics();
    const objectRanks& ranks = objects_.bodies().ranks();
    record.contacts = label(ranks.sum(contacts.contacts));
    record.smallestGap = -ranks.largest(-contacts.smallestGap);
    record.contactEnergy = ranks.sum(contacts.potentialEnergy);
    record.misfit = levelSet.misfit(objects_.surfaces());
    record.rebuilds = levelSet.nRebuilds();

    record.timeError = error.value();
    record.drivingAcceleration = objects_.driving().acceleration();
    stepTimer& timer = objects_.timer();
    timer.endStep(time.value(), time.deltaTValue(), time.endTime().value());
    record.seconds = timer.seconds();
    writer_.writeStep(record);
    runLog& log = objects_.log();
    log.setWarnings
    (
        "object pushed out at a feed",
        objects_.boundaries().nWarnings()
    );
    log.setWarnings("contact gives energy", objects_.contact().warned());
    log.finish(record, timer);
}


void Foam::fsi::stepOutput::writeRows(const vectorField& hydrodynamicForce)
{
    const population& bodies = objects_.bodies();
    List<objectRecord> records
    (
        objectRecord::sample(bodies, objects_.images().period())
    );
    const surfaceSet& surfaces = bodies.surfaces();
    const label nOwned = surfaces.pointStart()[bodies.size()];
    vectorField& pushes = objects_.contact().forces();
    pushes.setSize(surfaces.points().size(), Zero);
    for (label nodei = 0; nodei < nOwned; ++nodei)
    {
        objectRecord& r = records[surfaces.pointObject()[nodei]];
        const vector& force = hydrodynamicForce[nodei];
        r.force += force;
        r.torque += (surfaces.points()[nodei] - r.centroid) ^ force;
        r.contactForce += pushes[nodei];
    }
    if (rheology_.valid())
    {
        symmTensorField fluid, contact;
        objectStresses(objects_, hydrodynamicForce, fluid, contact);
        forAll(records, objecti)
        {
            records[objecti].stresslet = fluid[objecti];
            records[objecti].contactStress = contact[objecti];
        }
    }
    // Pairs of an object that no one pushes are at the ranks of the others
    const contactStatistics& contacts = objects_.contact().statistics();
    scalarField numbers(bodies.nHeld(), Zero), gaps(bodies.nHeld(), GREAT);
    forAll(contacts.objectContacts, objecti)
    {
        if (objecti < bodies.size() || !bodies.movesFreely(objecti))
        {
            numbers[objecti] = contacts.objectContacts[objecti];
            gaps[objecti] = contacts.objectGaps[objecti];
        }
    }
    if (!bodies.ranks().shared())
    {
        bodies.ranks().collect({objectRanks::values::ofObjects(numbers)});
        bodies.ranks().collectLeast(gaps);
    }
    forAll(records, objecti)
    {
        records[objecti].contacts = label(numbers[objecti]);
        records[objecti].smallestGap = gaps[objecti];
    }
    writer_.writeRows
    (
        objects_.grid().mesh().time().value(),
        objectRecord::gathered(bodies, records)
    );
}


void Foam::fsi::stepOutput::setFields()
{
    const levelSetUpdate& levelSet = objects_.levelSet();
    const labelList& halo = objects_.grid().haloIndex();
    forAll(halo, celli)
    {
        const label objecti = levelSet.objectAt(halo[celli]);
        signedDistance_[celli] = levelSet.cellDistance()[halo[celli]];
        objectLabel_[celli] =
            objecti < 0 ? -1 : objects_.bodies().objectId(objecti);
    }
    signedDistance_.correctBoundaryConditions();
    objectLabel_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::stepOutput::write
(
    const timeError& error,
    const vectorField& hydrodynamicForce
)
{
    report(error);
    const fvMesh& mesh = objects_.grid().mesh();
    const scalar time = mesh.time().value();
    if (frame_.valid())
    {
        const movingFrame& frame = objects_.frame();
        frame_().row() << time << frame.velocity() << frame.position();
    }
    if (rheology_.valid() && writer_.stepWanted())
    {
        symmTensorField fluid, contact;
        objectStresses(objects_, hydrodynamicForce, fluid, contact);
        rheology_->write(fluid, contact);
    }
    const bool output = mesh.time().writeTime();
    if (output || writer_.objectsWanted())
    {
        writeRows(hydrodynamicForce);
        followed_.write(time, objects_.bodies(), objects_.images().period());
    }
    if (!output)
    {
        return;
    }
    setFields();
    autoPtr<population> storage;
    const population& all = objects_.bodies().whole(storage);
    const bool overlaps = writer_.writeShapes
    (
        time,
        all,
        objects_.images().period(),
        gatheredTractions
        (
            objects_.bodies(), hydrodynamicForce, objects_.grid().thickness()
        )
    );
    if (overlaps)
    {
        objects_.log().warned("written time with objects inside others");
    }
    all.write();
    objects_.write();
    error.write();
    restartFiles::write(mesh);
}


void Foam::fsi::stepOutput::summary
(
    const timeError& error,
    Ostream& os
) const
{
    error.report(os);
    objects_.log().report(os);
    objects_.timer().report(os);
    if (severalRanks())
    {
        os  << "Work of the ranks" << nl << "    " << setw(10) << "kind"
            << setw(14) << "least" << setw(14) << "most" << setw(14)
            << "over mean" << nl;
        reportWork("cells", objects_.grid().mesh().nCells(), os);
        reportWork("nodes", objects_.bodies().nNodes(), os);
        reportWork("pairs", objects_.contact().nPairs(), os);
        os  << endl;
    }
}


// ************************************************************************* //
