// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "marchingCases.H"

#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A march from the zero of phi, whatever its type of seeds
static levelSetFields marched
(
    const cartesianBlock& block,
    const scalarField& phi,
    const word& seedType,
    const label order
)
{
    interfaceSeeds seeds(seedType);
    fastMarching marching(GREAT, order);
    levelSetFields fields;
    fields.phi = phi;
    fields.start(seeds, block);
    marching.march(block, fields);
    return fields;
}


// Values of scikit-fmm's tests: one sample inside
TEST(FastMarching, ThreeByThreeSamples)
{
    for (const scalar h : {1.0, 0.25})
    {
        const cartesianBlock block(point::zero, h, labelVector(3, 3, 1), 2);
        scalarField phi(9, 1.0);
        phi[4] = -1;
        for (const label order : {1, 2})
        {
            const levelSetFields fields(marched(block, phi, "linear", order));
            for (const label corner : {0, 2, 6, 8})
            {
                EXPECT_NEAR(fields.phi[corner], 1.20710678*h, 1e-8);
            }
            for (const label side : {1, 3, 5, 7})
            {
                EXPECT_NEAR(fields.phi[side], 0.5*h, 1e-14);
            }
            EXPECT_NEAR(fields.phi[4], -0.35355339*h, 1e-8);
        }
    }
}


// Means over [-1, 1]^2 computed with an independent program; within 1.2 times
TEST(FastMarching, CircleErrorsAndOrders)
{
    const FixedList<label, 4> n({32, 64, 128, 256});
    const FixedList<scalar, 4> first({5.20e-3, 3.23e-3, 1.79e-3, 9.39e-4});
    const FixedList<scalar, 4> second({5.95e-4, 2.02e-4, 5.75e-5, 1.52e-5});

    FixedList<scalar, 4> one, two;
    forAll(n, i)
    {
        one[i] = marchingError(n[i], 2, 1, circleDistance).mean;
        two[i] = marchingError(n[i], 2, 2, circleDistance).mean;
        EXPECT_LT(one[i], 1.2*first[i]);
        EXPECT_LT(two[i], 1.2*second[i]);
    }
    EXPECT_GT(convergenceOrder(one[2], one[3]), 0.9);
    EXPECT_GT(convergenceOrder(two[2], two[3]), 1.8);
}


// The order 2 needs seeds of at least order 2
TEST(FastMarching, SeedsOfTheCubicTypeKeepTheSecondOrder)
{
    const scalar cubic128 =
        reinitialisationError(128, 2, 2, "cubic", circleDistance).mean;
    const scalar cubic256 =
        reinitialisationError(256, 2, 2, "cubic", circleDistance).mean;
    EXPECT_GT(convergenceOrder(cubic128, cubic256), 1.8);
    EXPECT_LT(cubic128, 1.2*5.75e-5);

    const scalar linear256 =
        reinitialisationError(256, 2, 2, "linear", circleDistance).mean;
    EXPECT_GT(linear256, 5*cubic256);
}


// A corner is a source of a fan of characteristics, whose error with
// differences of first order is h log(h)
TEST(FastMarching, SquareCornersAndTwoDiscsConverge)
{
    const auto order = [](const label n, const label o, const pointFunction& f)
    {
        return convergenceOrder
        (
            marchingError(n, 2, o, f).mean,
            marchingError(2*n, 2, o, f).mean
        );
    };
    EXPECT_GT(order(128, 1, squareDistance), 0.65);
    EXPECT_GT(order(128, 2, squareDistance), 0.9);
    EXPECT_GT(order(128, 1, twoDiscsDistance), 0.85);
    EXPECT_GT(order(128, 2, twoDiscsDistance), 1.7);
    EXPECT_LT(marchingError(128, 2, 2, squareDistance).largest, 0.4*2.0/128);
}


TEST(FastMarching, SphereErrorsAndOrders)
{
    const scalar one = marchingError(24, 3, 1, circleDistance).mean;
    const scalar two = marchingError(24, 3, 2, circleDistance).mean;
    const scalar oneFine = marchingError(48, 3, 1, circleDistance).mean;
    const scalar twoFine = marchingError(48, 3, 2, circleDistance).mean;
    EXPECT_LT(oneFine, 0.01);
    EXPECT_LT(twoFine, 6e-4);
    EXPECT_GT(convergenceOrder(one, oneFine), 0.5);
    EXPECT_GT(convergenceOrder(two, twoFine), 1.4);

    const scalar cubic =
        reinitialisationError(48, 3, 2, "cubic", circleDistance).mean;
    EXPECT_LT(cubic, 1.3*twoFine);
}


TEST(FastMarching, EllipseBecomesADistanceWithoutMoving)
{
    scalar coarse = 0;
    for (const label n : {64, 128})
    {
        const scalar h = 10.0/n;
        const reinitialisationErrors errors(ellipseError(n, 10));
        EXPECT_LT(errors.interface.mean, 0.002*h);
        EXPECT_LT(errors.motion, 0.05*h);
        if (n == 128)
        {
            const scalar order = convergenceOrder(coarse, errors.all.mean);
            EXPECT_GT(order, 1.7);
        }
        coarse = errors.all.mean;
    }
}


TEST(FastMarching, ExtensionIsOrthogonalToTheNormal)
{
    const FixedList<label, 4> n({32, 64, 128, 256});
    const FixedList<scalar, 4> first({0.116, 0.082, 0.048, 0.026});
    const FixedList<scalar, 4> second({0.100, 0.063, 0.035, 0.018});
    FixedList<scalar, 4> one, two;
    forAll(n, i)
    {
        one[i] = extensionError(n[i], 1).orthogonality.mean;
        two[i] = extensionError(n[i], 2).orthogonality.mean;
        EXPECT_LT(one[i], 1.1*first[i]);
        EXPECT_LT(two[i], 1.1*second[i]);
    }
    EXPECT_GT(convergenceOrder(one[2], one[3]), 0.85);
    EXPECT_GT(convergenceOrder(two[2], two[3]), 0.85);

    EXPECT_GT
    (
        convergenceOrder
        (
            extensionError(128, 2).value.mean,
            extensionError(256, 2).value.mean
        ),
        0.85
    );
}


// A planar front: value and label are carried straight on
TEST(FastMarching, PlanarFrontCarriesVelocityAndObjectUnchanged)
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


TEST(FastMarching, ObjectIsTheNearest)
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


TEST(FastMarching, BandEndsWhereAskedAndCostsNoMoreThanItsSamples)
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
TEST(FastMarching, AcceptsByIncreasingDistance)
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


TEST(FastMarching, BlockWithAHaloAgreesWithTheWhole)
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


TEST(FastMarching, RefusesBadInput)
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
    EXPECT_THROW(interfaceSeeds("quintic"), Foam::error);

    // Exact distance that misses samples beside the surface
    surfaceSet surfaces(2);
    appendDisc(surfaces, point::zero, 0.5, 40);
    surfaceDistance thin(0.9*h);
    EXPECT_THROW(fields.start(thin, surfaces, block), Foam::error);
}


TEST(FastMarching, DictionaryEntriesAreChecked)
{
    const auto make = [](const char* text)
    {
        IStringStream stream(text);
        return fastMarching(dictionary(stream), 0.1);
    };
    EXPECT_DOUBLE_EQ(make("").bandWidth(), 0.4);
    EXPECT_DOUBLE_EQ(make("order 1; bandWidth 6;").bandWidth(), 0.6);
    EXPECT_THROW(make("order 3;"), Foam::IOerror);
    EXPECT_THROW(make("bandWidth -1;"), Foam::IOerror);
    EXPECT_THROW(make("bandwidth 4;"), Foam::IOerror);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
