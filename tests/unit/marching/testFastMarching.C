// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "reinitialisationCases.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A march from the zero of phi
static levelSetFields marched
(
    const cartesianBlock& block,
    const scalarField& phi,
    const label order
)
{
    interfaceSeeds seeds;
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
            const levelSetFields fields(marched(block, phi, order));
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
TEST(FastMarching, SeedsKeepTheSecondOrder)
{
    const scalar cubic128 =
        reinitialisationError(128, 2, 2, circleDistance).mean;
    const scalar cubic256 =
        reinitialisationError(256, 2, 2, circleDistance).mean;
    EXPECT_GT(convergenceOrder(cubic128, cubic256), 1.8);
    EXPECT_LT(cubic128, 1.2*5.75e-5);
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
        reinitialisationError(48, 3, 2, circleDistance).mean;
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

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
