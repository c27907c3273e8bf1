// SPDX-License-Identifier: GPL-3.0-or-later

#include "followedTable.H"
#include "gatheredObjects.H"
#include "objectWriter.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The followed places of an object
struct followedObject
{
    label group;
    label id;

    //- Of each place [m], [m/s]
    vectorField positions, velocities;
};


//- Places of a rank's own objects
static List<followedObject> sample
(
    const population& objects,
    const vector& period
)
{
    const surfaceSet& surfaces = objects.surfaces();
    List<followedObject> all(objects.size());
    forAll(all, objecti)
    {
        const label groupi = objects.objectGroup(objecti);
        const followedNodes& followed = objects.shape(groupi).followed();
        const label start = surfaces.pointStart()[objecti];
        const label n = surfaces.pointStart()[objecti + 1] - start;
        const SubField<vector> points(surfaces.points(), n, start);
        const SubField<vector> velocities(surfaces.velocities(), n, start);
        const vector shift
        (
            objects.groups()[groupi].movedBack
            (
                objects.objectCopy(objecti), period
            )
        );
        followedObject& object = all[objecti];
        object.group = groupi;
        object.id = objects.objectId(objecti);
        object.positions.setSize(followed.names().size());
        object.velocities.setSize(followed.names().size());
        forAll(object.positions, placei)
        {
            object.positions[placei] = followed.mean(placei, points) + shift;
            object.velocities[placei] = followed.mean(placei, velocities);
        }
    }
    return all;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::followedTable::followedTable
(
    const Time& time,
    const population& objects
)
{
    forAll(objects.groups(), groupi)
    {
        wanted_ |= !objects.shape(groupi).followed().names().empty();
    }
    if (wanted_)
    {
        table_ = objectWriter::newTable
        (
            time,
            "followed",
            {
                "time", "object", "shape", "place", "positionX", "positionY",
                "positionZ", "velocityX", "velocityY", "velocityZ"
            }
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::followedTable::write
(
    const scalar time,
    const population& objects,
    const vector& period
)
{
    if (!wanted_)
    {
        return;
    }
    const List<followedObject> all
    (
        gatheredObjects
        (
            objects,
            sample(objects, period),
            [&](copyValues& values, followedObject& object, const label groupi)
            {
                const label n = objects.shape(groupi).followed().names().size();
                object.group = groupi;
                values.number(object.id);
                object.positions.setSize(n);
                object.velocities.setSize(n);
                for (label placei = 0; placei < n; ++placei)
                {
                    values.vectorOf(object.positions[placei]);
                    values.vectorOf(object.velocities[placei]);
                }
            }
        )
    );
    if (!table_.valid())
    {
        return;
    }
    for (const followedObject& object : all)
    {
        const shapeTemplate& shape = objects.shape(object.group);
        forAll(object.positions, placei)
        {
            table_->row()
                << time << object.id << shape.name()
                << shape.followed().names()[placei]
                << object.positions[placei] << object.velocities[placei];
        }
    }
}


// ************************************************************************* //
