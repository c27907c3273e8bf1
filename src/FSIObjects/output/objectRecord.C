// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectRecord.H"
#include "csvTable.H"
#include "faceStretches.H"
#include "gatheredObjects.H"
#include "surfaceMoments.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsi::objectRecord>
Foam::fsi::objectRecord::sample
(
    const population& objects,
    const vector& period
)
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
        r.unwrapped = r.centroid + group.movedBack(copyi, period);
        r.velocity = group.velocity(copyi);
        r.angularVelocity = group.angularVelocity(copyi);
        r.area = surfaces.volume(objecti);
        r.perimeter = surfaces.surfaceArea(objecti);

        const surfaceMoments m(surfaces, objecti, r.centroid);
        r.halfAxes = m.halfLengths();
        r.longAxis = m.longAxis();
        r.shortAxis = m.shortAxis(surfaces.nDims());
        r.stretch = max(faceStretches(objects, objecti).larger);
        r.deformation = m.deformation(surfaces.nDims());
        r.flowAngle = std::acos(min(r.longAxis.x(), scalar(1)));
        const symmTensor& M = m.moments();
        r.inclination = 0.5*std::atan2(2*M.xy(), M.xx() - M.yy());
        if (surfaces.nDims() == 2)
        {
            const vector first
            (
                surfaces.points()[surfaces.pointStart()[objecti]] - r.centroid
            );
            r.phase = std::atan2(first.y(), first.x());
        }
        else
        {
            r.setSolid(objects, objecti);
        }
    }
    return records;
}


void Foam::fsi::objectRecord::setSolid
(
    const population& objects,
    const label objecti
)
{
    // The node most in the direction (1 1 1) at rest: it is far from all axes
    const shapeTemplate& rest = objects.shape(objects.objectGroup(objecti));
    label marked = 0;
    for (label nodei = 1; nodei < rest.nBoundaryNodes(); ++nodei)
    {
        const vector& best = rest.points()[marked];
        marked = cmptSum(rest.points()[nodei]) > cmptSum(best) ? nodei : marked;
    }
    const surfaceSet& surfaces = objects.surfaces();
    const label first = surfaces.pointStart()[objecti];
    const vector d(surfaces.points()[first + marked] - centroid);
    phases = vector
    (
        std::atan2(d.z(), d.y()),
        std::atan2(d.x(), d.z()),
        std::atan2(d.y(), d.x())
    );
}


void Foam::fsi::objectRecord::exchange(copyValues& values)
{
    values.number(object);
    values.number(contacts);
    for
    (
        scalar* each :
        {
            &area, &perimeter, &inclination, &phase, &deformation, &flowAngle,
            &smallestGap, &stretch
        }
    )
    {
        values.number(*each);
    }
    for (direction i = 0; i < symmTensor::nComponents; ++i)
    {
        values.number(stresslet[i]);
        values.number(contactStress[i]);
    }
    for
    (
        vector* each :
        {
            &centroid, &velocity, &angularVelocity, &halfAxes, &longAxis,
            &shortAxis, &force, &torque, &phases, &unwrapped, &contactForce
        }
    )
    {
        values.vectorOf(*each);
    }
}


Foam::List<Foam::fsi::objectRecord> Foam::fsi::objectRecord::gathered
(
    const population& objects,
    const List<objectRecord>& mine
)
{
    return gatheredObjects
    (
        objects,
        mine,
        [&](copyValues& values, objectRecord& record, const label groupi)
        {
            record.exchange(values);
            record.shape = objects.shape(groupi).name();
        }
    );
}


Foam::wordList Foam::fsi::objectRecord::columns
(
    const direction nDims,
    const bool stresses
)
{
    wordList names
    ({
        "time", "object", "shape",
        "centroidX", "centroidY", "centroidZ",
        "velocityX", "velocityY", "velocityZ",
        "angularVelocityX", "angularVelocityY", "angularVelocityZ"
    });
    names.append
    (
        nDims == 2
      ? wordList({"area", "perimeter", "inclination", "phase"})
      : wordList({"volume", "surface"})
    );
    names.append
    (
        wordList
        ({
            "forceX", "forceY", "forceZ",
            "contacts", "smallestGap",
            "torqueX", "torqueY", "torqueZ",
            "deformation", "stretch"
        })
    );
    if (nDims == 3)
    {
        names.append
        (
            wordList
            ({
                "flowAngle", "halfAxisA", "halfAxisB", "halfAxisC",
                "longAxisX", "longAxisY", "longAxisZ",
                "shortAxisX", "shortAxisY", "shortAxisZ",
                "inclination", "phaseX", "phaseY", "phaseZ"
            })
        );
    }
    names.append
    (
        wordList
        ({
            "unwrappedX", "unwrappedY", "unwrappedZ",
            "contactForceX", "contactForceY", "contactForceZ"
        })
    );
    if (stresses)
    {
        names.append
        (
            wordList
            ({
                "stressletXX", "stressletXY", "stressletXZ",
                "stressletYY", "stressletYZ", "stressletZZ",
                "contactStressXX", "contactStressXY", "contactStressXZ",
                "contactStressYY", "contactStressYZ", "contactStressZZ"
            })
        );
    }
    return names;
}


void Foam::fsi::objectRecord::write
(
    csvTable& table,
    const scalar time,
    const direction nDims,
    const bool stresses
) const
{
    csvTable::rowWriter row(table);
    row << time << object << shape
        << centroid << velocity << angularVelocity
        << area << perimeter;
    if (nDims == 2)
    {
        row << inclination << phase;
    }
    row << force << contacts << smallestGap << torque << deformation
        << stretch;
    if (nDims == 3)
    {
        row << flowAngle << halfAxes << longAxis << shortAxis
            << inclination << phases;
    }
    row << unwrapped << contactForce;
    for (direction i = 0; stresses && i < symmTensor::nComponents; ++i)
    {
        row << stresslet[i];
    }
    for (direction i = 0; stresses && i < symmTensor::nComponents; ++i)
    {
        row << contactStress[i];
    }
}


// ************************************************************************* //
