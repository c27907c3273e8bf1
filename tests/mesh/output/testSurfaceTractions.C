// SPDX-License-Identifier: GPL-3.0-or-later

#include "population/discRow.H"
#include "surfaceTractions.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;


TEST(surfaceTractions, areForceOverAreaOfAllObjectsOnTheFirstRank)
{
    const discRow row(1);
    const population& objects = *row.objects;
    const surfaceSet& surfaces = objects.surfaces();
    const scalar thickness = 3;

    // Traction (id, node of the object, 0) on each node, and another one on the
    // nodes of guests
    vectorField force(surfaces.points().size(), vector(7, 7, 7));
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label n = surfaces.pointStart()[objecti + 1] - start;
        for (label i = 0; i < n; ++i)
        {
            const point& here = surfaces.points()[start + i];
            const point& next = surfaces.points()[start + (i + 1) % n];
            const point& last = surfaces.points()[start + (i + n - 1) % n];
            force[start + i] =
                vector(objects.objectId(objecti), i, 0)
               *thickness*0.5*(mag(next - here) + mag(here - last));
        }
    }
    const vectorField found(gatheredTractions(objects, force, thickness));

    autoPtr<population> storage;
    const population& all = objects.whole(storage);
    if (rankIn() > 0)
    {
        return;
    }
    const labelList& start = all.surfaces().pointStart();
    ASSERT_EQ(found.size(), start.last());
    for (label objecti = 0; objecti < all.size(); ++objecti)
    {
        for (label nodei = start[objecti]; nodei < start[objecti + 1]; ++nodei)
        {
            const vector expected
            (
                all.objectId(objecti), nodei - start[objecti], 0
            );
            EXPECT_NEAR(mag(found[nodei] - expected), 0, 1e-10) << nodei;
        }
    }
}


// ************************************************************************* //
