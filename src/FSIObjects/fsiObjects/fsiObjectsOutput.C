// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjects.H"
#include "meanFluidVelocity.H"
#include "objectContact.H"
#include "restartFiles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fsiObjects::report()
{
    const population& objects = system_.objects;
    const Time& time = mesh_.time();

    stepRecord record(stepRecord::sample(objects));
    record.time = time.value();
    record.deltaT = time.deltaTValue();
    record.removed = boundaries_.nRemoved();
    record.fed = boundaries_.nFed();
    record.fluidVelocity = meanFluidVelocity
    (
        mesh_.lookupObject<volVectorField>("U"),
        *system_.levelSet,
        system_.grid.haloIndex()
    );
    const contactStatistics& contacts = system_.contacts->statistics();
    record.contacts = contacts.contacts;
    record.smallestGap = contacts.smallestGap;
    record.contactEnergy = contacts.potentialEnergy;
    record.misfit = system_.levelSet->misfit(system_.surfaces());
    record.rebuilds = system_.levelSet->nRebuilds();

    record.timeError = timeError_.value();
    timer_.endStep(time.value(), time.deltaTValue(), time.endTime().value());
    record.seconds = timer_.seconds();
    writer_.writeStep(record);
    system_.log->setWarnings
    (
        "object pushed out at a feed",
        boundaries_.nWarnings()
    );
    system_.log->setWarnings
    (
        "contact gives energy",
        system_.contacts->warned()
    );
    system_.log->finish(record, timer_);
}


void Foam::fsi::fsiObjects::writeRows()
{
    List<objectRecord> records(objectRecord::sample(system_.objects));
    const surfaceSet& surfaces = system_.objects.surfaces();
    const labelList& pointObject = surfaces.pointObject();
    forAll(pointObject, nodei)
    {
        objectRecord& r = records[pointObject[nodei]];
        const vector& force = coupling_->hydrodynamicForce()[nodei];
        r.force += force;
        r.torque += (surfaces.points()[nodei] - r.centroid) ^ force;
    }
    const contactStatistics& contacts = system_.contacts->statistics();
    forAll(contacts.objectContacts, objecti)
    {
        records[objecti].contacts = contacts.objectContacts[objecti];
        records[objecti].smallestGap = contacts.objectGaps[objecti];
    }
    writer_.writeRows(mesh_.time().value(), records);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fsiObjects::write()
{
    report();
    const bool output = mesh_.time().writeTime();
    if (output || writer_.objectsWanted())
    {
        writeRows();
    }
    if (!output)
    {
        return;
    }

    const population& objects = system_.objects;
    const labelList& halo = system_.grid.haloIndex();
    forAll(halo, celli)
    {
        const label objecti = system_.levelSet->object()[halo[celli]];
        signedDistance_[celli] = system_.levelSet->cellDistance()[halo[celli]];
        objectLabel_[celli] = objecti < 0 ? -1 : objects.objectId(objecti);
    }
    signedDistance_.correctBoundaryConditions();
    objectLabel_.correctBoundaryConditions();

    writer_.writeShapes(mesh_.time().value(), objects);
    objects.write();
    system_.contacts->write();
    boundaries_.write();
    system_.driving->write();
    timeError_.write();
    restartFiles::write(mesh_);
}


void Foam::fsi::fsiObjects::summary(Ostream& os) const
{
    timeError_.report(os);
    system_.log->report(os);
    timer_.report(os);
}


// ************************************************************************* //
