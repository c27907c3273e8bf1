// SPDX-License-Identifier: GPL-3.0-or-later

#include "someObjects.H"

#include "cpuTime.H"
#include <gtest/gtest.h>

using namespace Foam;
using Foam::fsi::boxMesh;
using Foam::fsi::population;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

// One after the other they took a time that grew with the square of the number
TEST(Population, manyObjectsAreAddedAndFoundInAShortTime)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<population> objects = someObjects::make(box.time());
    const label n = 20000;
    labelList groups(n);
    pointField centres(n);
    vectorField velocities(n);
    forAll(groups, i)
    {
        groups[i] = i % 2;
        centres[i] = point(i, -i, 0);
        velocities[i] = vector(0, i, 0);
    }
    cpuTime clock;
    const labelList ids
    (
        objects->append
        (
            groups, centres, tensorField(n, tensor::I), velocities,
            vectorField(n, Zero)
        )
    );
    ASSERT_EQ(objects->size(), n + 5);
    for (label i = 0; i < n; ++i)
    {
        const label objecti = objects->findObject(ids[i]);
        ASSERT_GE(objecti, 0);
        const label groupi = objects->objectGroup(objecti);
        const label copyi = objects->objectCopy(objecti);
        ASSERT_EQ(objects->objectId(objecti), ids[i]);
        ASSERT_EQ(groupi, groups[i]);
        const auto& group = objects->groups()[groupi];
        ASSERT_NEAR(group.centroid(copyi).x(), i, 1e-9*(1 + i));
        ASSERT_NEAR(group.velocity(copyi).y(), i, 1e-9*(1 + i));
    }
    EXPECT_LT(clock.elapsedCpuTime(), 10);
}


// ************************************************************************* //
