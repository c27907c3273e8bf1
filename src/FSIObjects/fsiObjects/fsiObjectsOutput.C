// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjects.H"
#include "objectContact.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Largest speed of a node of a group [m/s]
static scalar maxSpeed(const bodyGroup& group, const direction nDims)
{
    const Eigen::MatrixXd& v = group.velocities();
    scalar largest = 0;
    for (label copyi = 0; copyi < group.size(); ++copyi)
    {
        largest = max
        (
            largest,
            v.middleCols(nDims*copyi, nDims).rowwise().squaredNorm().maxCoeff()
        );
    }
    return sqrt(largest);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fsiObjects::report()
{
    const population& objects = system_.objects;
    const Time& time = mesh_.time();

    stepRecord record;
    record.time = time.value();
    record.deltaT = time.deltaTValue();
    record.objects = objects.size();
    record.removed = boundaries_.nRemoved();
    record.fed = boundaries_.nFed();
    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        record.maxSpeed =
            max(record.maxSpeed, maxSpeed(group, objects.nDims()));
        record.kineticEnergy += group.kineticEnergy();
        record.elasticEnergy += group.elasticEnergy();
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            record.areaChange = max
            (
                record.areaChange,
                mag(group.volume(copyi)/group.shape().referenceVolume() - 1)
            );
        }
    }
    const contactStatistics& contacts = system_.contacts->statistics();
    record.contacts = contacts.contacts;
    record.smallestGap = contacts.smallestGap;
    record.contactEnergy = contacts.potentialEnergy;
    record.misfit = system_.levelSet->misfit(system_.surfaces());
    record.rebuilds = system_.levelSet->nRebuilds();

    timer_.endStep(time.value(), time.deltaTValue(), time.endTime().value());
    record.seconds = timer_.seconds();
    writer_.writeStep(record);
    record.log(Info, timer_);
}


void Foam::fsi::fsiObjects::writeRows()
{
    List<objectRecord> records(objectRecord::sample(system_.objects));
    const labelList& pointObject = system_.objects.surfaces().pointObject();
    forAll(pointObject, nodei)
    {
        records[pointObject[nodei]].force +=
            coupling_->hydrodynamicForce()[nodei];
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
    const bool output = mesh_.time().outputTime();
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
    boundaries_.write();
    system_.driving->write();
}


// ************************************************************************* //
