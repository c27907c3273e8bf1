// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectRecord.H"
#include "csvTable.H"
#include "population.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsi::objectRecord>
Foam::fsi::objectRecord::sample(const population& objects)
{
    const surfaceSet& surfaces = objects.surfaces();

    List<objectRecord> records(objects.size());
    forAll(records, objecti)
    {
        objectRecord& r = records[objecti];
        const label groupi = objects.objectGroup(objecti);
        const label copyi = objects.objectCopy(objecti);
        const bodyGroup& group = objects.groups()[groupi];

        r.object = objects.objectId(objecti);
        r.shape = objects.shape(groupi).name();
        r.centroid = surfaces.centroid(objecti);
        r.velocity = group.velocity(copyi);
        r.angularVelocity = group.angularVelocity(copyi);
        r.area = surfaces.volume(objecti);
        r.perimeter = surfaces.surfaceArea(objecti);
    }
    return records;
}


Foam::wordList Foam::fsi::objectRecord::columns()
{
    return wordList
    ({
        "time", "object", "shape",
        "centroidX", "centroidY", "centroidZ",
        "velocityX", "velocityY", "velocityZ",
        "angularVelocityX", "angularVelocityY", "angularVelocityZ",
        "area", "perimeter",
        "forceX", "forceY", "forceZ",
        "contacts", "smallestGap"
    });
}


void Foam::fsi::objectRecord::write(csvTable& table, const scalar time) const
{
    table.row()
        << time << object << shape
        << centroid << velocity << angularVelocity
        << area << perimeter << force
        << contacts << smallestGap;
}


// ************************************************************************* //
