// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "marchingCases.H"

#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

// A planar front: value and label are carried straight on
TEST(FastMarchingBand, PlanarFrontCarriesVelocityAndObjectUnchanged)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 32, 3));
    levelSetFields fields
    (
        exactSeeds
        (
            block,
            [](const point& p) { return p.z() + 0.1; },
            1.5*block.spacing()
        )
    );
    fields.object = 7;
    for (const label samplei : fields.seeds)
    {
        fields.velocity[samplei] = vector(1, -2, 3);
    }
    fastMarching marching(GREAT, 2);
    marching.march(block, fields);
    forAll(fields.phi, samplei)
    {
        const point p(block.position(samplei));
        ASSERT_NEAR(fields.phi[samplei], p.z() + 0.1, 1e-13);
        ASSERT_NEAR(mag(fields.velocity[samplei] - vector(1, -2, 3)), 0, 1e-13);
        ASSERT_EQ(fields.object[samplei], 7);
    }
}


TEST(FastMarchingBand, ObjectIsTheNearest)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(-0.45, -0.3, 0), 0.3, 60);
    appendDisc(surfaces, point(0.45, -0.3, 0), 0.2, 60);
    appendDisc(surfaces, point(0, 0.5, 0), 0.25, 60);
    const cartesianBlock block(cellCentres(-point::one, 2, 100, 2));
    const scalar h = block.spacing();

    surfaceDistance nearSurfaces(1.5*h), everywhere(4);
    levelSetFields fields;
    fields.start(nearSurfaces, surfaces, block);
    fastMarching marching(GREAT);
    marching.march(block, fields);
    everywhere.update(surfaces, block);

    label nOther = 0;
    forAll(fields.phi, samplei)
    {
        ASSERT_NEAR(fields.phi[samplei], everywhere.distance()[samplei], h);
        nOther += fields.object[samplei] != everywhere.object()[samplei];
    }
    // Only samples on the border lines between objects may differ
    EXPECT_LT(nOther, 100);
}


TEST(FastMarchingBand, BandEndsWhereAskedAndCostsNoMoreThanItsSamples)
{
    label fewer = 0;
    for (const label n : {64, 128, 256})
    {
        const cartesianBlock block(cellCentres(-point::one, 2, n, 2));
        const scalar h = block.spacing(), band = 5*h;
        levelSetFields fields(exactSeeds(block, circleDistance, 1.5*h));
        fields.velocity = vector::one;
        fastMarching marching(band);
        marching.march(block, fields);

        label nInBand = 0;
        forAll(fields.phi, samplei)
        {
            const point p(block.position(samplei));
            const scalar exact = circleDistance(p);
            ASSERT_LE(mag(fields.phi[samplei]), band);
            ASSERT_EQ(fields.phi[samplei] < 0, exact < 0);
            if (mag(fields.phi[samplei]) < band)
            {
                ++nInBand;
                ASSERT_EQ(fields.object[samplei], 0);
            }
            else
            {
                ASSERT_GT(mag(exact), band - 0.2*h);
                ASSERT_EQ(fields.object[samplei], -1);
                ASSERT_EQ(fields.velocity[samplei], vector::zero);
            }
        }
        EXPECT_EQ(nInBand, marching.reached().size());
        if (fewer > 0)
        {
            EXPECT_NEAR(scalar(nInBand)/fewer, 2, 0.1);
        }
        fewer = nInBand;
    }
}


// Values by increasing distance on either side of the seeds
TEST(FastMarchingBand, AcceptsByIncreasingDistance)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 60, 2));
    levelSetFields fields
    (
        exactSeeds(block, twoDiscsDistance, 1.5*block.spacing())
    );
    fastMarching marching(GREAT, 1);
    marching.march(block, fields);
    const labelUList& reached = marching.reached();
    EXPECT_EQ(reached.size(), block.size());
    for (label i = fields.seeds.size() + 1; i < reached.size(); ++i)
    {
        ASSERT_GE
        (
            mag(fields.phi[reached[i]]) + 1e-14,
            mag(fields.phi[reached[i - 1]])
        );
    }
}


TEST(FastMarchingBand, BlockWithAHaloAgreesWithTheWhole)
{
    surfaceSet surfaces(2);
    appendStar(surfaces, point(0, 0, 0), 0.25, 0.6, 5);
    appendDisc(surfaces, point(0.6, 0.6, 0), 0.2, 40);
    const label n = 96, halo = 6;
    const cartesianBlock whole(cellCentres(-point::one, 2, n, 2));
    const scalar h = whole.spacing();
    surfaceDistance exact(1.5*h);
    fastMarching marching(halo*h);

    levelSetFields all, some;
    all.start(exact, surfaces, whole);
    marching.march(whole, all);

    // The left half and its halo
    const cartesianBlock part
    (
        whole.origin(), h, labelVector(n/2 + halo, n, 1), 2
    );
    some.start(exact, surfaces, part);
    marching.march(part, some, halo);
    for (label j = 0; j < n; ++j)
    {
        for (label i = 0; i < n/2; ++i)
        {
            const label a = whole.index(i, j, 0), b = part.index(i, j, 0);
            ASSERT_NEAR(all.phi[a], some.phi[b], 1e-10*h);
            ASSERT_EQ(all.object[a], some.object[b]);
        }
    }
}


TEST(FastMarchingBand, RefusesBadInput)
{
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const cartesianBlock block(cellCentres(-point::one, 2, 32, 2));
    const scalar h = block.spacing();
    const levelSetFields good(exactSeeds(block, circleDistance, 2*h));
    fastMarching marching(4*h);

    levelSetFields fields(good);
    EXPECT_NO_THROW(marching.march(block, fields, 4));
    fields = good;
    EXPECT_THROW(marching.march(block, fields, 3), Foam::error);

    levelSetFields empty(good);
    empty.phi = 1;
    interfaceSeeds seeds;
    empty.start(seeds, block);
    EXPECT_THROW(marching.march(block, empty), Foam::error);

    fields = good;
    fields.phi[5] = nan;
    EXPECT_THROW(marching.march(block, fields), Foam::error);
    fields = good;
    fields.velocity[fields.seeds[3]].y() = nan;
    EXPECT_THROW(marching.march(block, fields), Foam::error);
    fields = good;
    fields.velocity.setSize(3);
    EXPECT_THROW(marching.march(block, fields), Foam::error);

    EXPECT_THROW(fastMarching(h, 3), Foam::error);
    EXPECT_THROW(fastMarching(0), Foam::error);

    // Exact distance that misses samples beside the surface
    surfaceSet surfaces(2);
    appendDisc(surfaces, point::zero, 0.5, 40);
    surfaceDistance thin(0.9*h);
    EXPECT_THROW(fields.start(thin, surfaces, block), Foam::error);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
