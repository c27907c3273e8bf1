// SPDX-License-Identifier: GPL-3.0-or-later

// Objects owned by ranks

#include "discRow.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;


TEST(objectRanks, eachObjectHasOneOwnerThatHoldsItsCentre)
{
    const discRow row(1);
    const labelList ids(row.owned());
    ASSERT_EQ(ids.size(), 8);
    EXPECT_EQ(row.objects->nAll(), 8);
    for (label i = 1; i < 8; ++i)
    {
        EXPECT_EQ(ids[i], ids[0] + i);
    }
    for (label objecti = 0; objecti < row.objects->size(); ++objecti)
    {
        const bodyGroup& group = row.objects->groups()[0];
        EXPECT_GE(row.grid.findCell(group.centroid(objecti)), 0);
    }
    // On three ranks the first one does not know the last disc
    EXPECT_EQ
    (
        row.objects->findObject(ids[7]) >= 0,
        rankIn() == nRanksIn() - 1
    );
}


TEST(objectRanks, readsForEachRankItsOwnObjects)
{
    discRow row(1);
    population& objects = *row.objects;
    for (const label nOwned : {objects.size(), label(8)})
    {
        const bodyGroup& group = objects.groups()[0];
        EXPECT_EQ(objects.size(), nOwned);
        EXPECT_EQ(group.positions().cols(), 2*nOwned);
        EXPECT_TRUE(group.history());
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            const label id = group.objectIds()[copyi];
            EXPECT_EQ(objects.groups()[0].contactRange(copyi), id + 0.25);
            EXPECT_EQ
            (
                objects.groups()[0].contactForce()(0, 2*copyi),
                id - 0.5
            );
            EXPECT_NEAR(group.centroid(copyi).x(), 1.5 + 3*(id - 5), 1e-12);
        }
        EXPECT_EQ(nOwned < 8, severalRanks() && objects.ranks().nRanks() > 0);
        objects.holdAll();
    }
    EXPECT_EQ(objects.groups()[0].objectIds(), identityList(8, 5));
}


TEST(objectRanks, collectsPartsAndSpreadsWhatIsComplete)
{
    const discRow row(4);
    const population& objects = *row.objects;
    const surfaceSet& surfaces = objects.surfaces();

    // Each holder has a part of 1
    vectorField nodal(surfaces.points().size(), vector(1, 0, 2));
    scalarField holders(objects.nHeld(), 1);
    objects.ranks().collect({objectRanks::values::ofObjects(holders)});
    objects.ranks().collect({objectRanks::values::ofNodes(nodal)});
    objects.ranks().spread
    ({
        objectRanks::values::ofNodes(nodal),
        objectRanks::values::ofObjects(holders)
    });
    scalar most = 0;
    forAll(nodal, nodei)
    {
        const scalar n = holders[surfaces.pointObject()[nodei]];
        EXPECT_EQ(nodal[nodei], n*vector(1, 0, 2));
        most = max(most, n);
    }
    EXPECT_EQ(overRanks(most, maxOp<scalar>()) > 1, severalRanks());
}


TEST(objectRanks, objectsGoToOtherRanksWithTheirStateAndForces)
{
    discRow row(1);
    population& objects = *row.objects;
    const labelList ids(row.owned());
    for (label step = 0; step < 12; ++step)
    {
        vectorField force(objects.layout().nSurface(), Zero);
        bodyGroup& group = objects.groups()[0];
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            const scalar id = group.objectIds()[copyi];
            group.positions().col(2*copyi).array() += id == ids[0] ? 1.5 : 0;
            group.contactRange(copyi) = id + 0.5;
            const label start = objects.surfaces().pointStart()[copyi];
            const label end = objects.surfaces().pointStart()[copyi + 1];
            for (label i = start; i < end; ++i)
            {
                force[i] = vector(id, i - start, 0);
            }
        }
        objects.updateSurfaces();
        objects.migrate({&force});
        ASSERT_EQ(row.owned(), ids);
        for (label objecti = 0; objecti < objects.size(); ++objecti)
        {
            const label id = objects.objectId(objecti);
            const label start = objects.surfaces().pointStart()[objecti];
            EXPECT_EQ(objects.findObject(id), objecti);
            EXPECT_EQ(objects.groups()[0].contactRange(objecti), id + 0.5);
            EXPECT_EQ(force[start + 1], vector(id, 1, 0));
            EXPECT_GE
            (
                row.grid.findCell(objects.groups()[0].centroid(objecti)), 0
            );
        }
    }

    // The first rank has all of them as one population again
    autoPtr<population> storage;
    const population& all = objects.whole(storage);
    ASSERT_EQ(all.size(), rankIn() == 0 ? 8 : 0);
    for (label i = 0; i < all.size(); ++i)
    {
        EXPECT_EQ(all.objectId(i), ids[i]);
        EXPECT_NEAR
        (
            all.groups()[0].centroid(i).x(),
            1.5 + (i == 0 ? 18 : 3*i),
            0.2
        );
    }
}


// ************************************************************************* //
