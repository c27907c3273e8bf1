// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectRecord.H"
#include "csvTable.H"
#include "population.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Second moments of the area about the centroid: xx, yy, xy [m^4]
static FixedList<scalar, 3> secondMoments
(
    const bodyGroup& group,
    const label copyi,
    const point& centroid
)
{
    FixedList<scalar, 3> moments(scalar(0));
    const auto x = group.positions().middleCols(2*copyi, 2);
    for (const surfaceFace& face : group.shape().faces())
    {
        const scalar ax = x(face[0], 0) - centroid.x();
        const scalar ay = x(face[0], 1) - centroid.y();
        const scalar bx = x(face[1], 0) - centroid.x();
        const scalar by = x(face[1], 1) - centroid.y();
        const scalar twelfth = (ax*by - ay*bx)/12;
        moments[0] += twelfth*(ax*ax + ax*bx + bx*bx);
        moments[1] += twelfth*(ay*ay + ay*by + by*by);
        moments[2] += twelfth*(ax*ay + bx*by + 0.5*(ax*by + ay*bx));
    }
    return moments;
}

} // End namespace fsi
} // End namespace Foam


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
        if (group.shape().nDims() == 2)
        {
            const FixedList<scalar, 3> moments
            (
                secondMoments(group, copyi, r.centroid)
            );
            r.inclination =
                0.5*std::atan2(2*moments[2], moments[0] - moments[1]);
            r.phase = std::atan2
            (
                group.positions()(0, 2*copyi + 1) - r.centroid.y(),
                group.positions()(0, 2*copyi) - r.centroid.x()
            );
        }
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
        "area", "perimeter", "inclination", "phase",
        "forceX", "forceY", "forceZ",
        "contacts", "smallestGap"
    });
}


void Foam::fsi::objectRecord::write(csvTable& table, const scalar time) const
{
    table.row()
        << time << object << shape
        << centroid << velocity << angularVelocity
        << area << perimeter << inclination << phase << force
        << contacts << smallestGap;
}


// ************************************************************************* //
