// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "openArea.H"

#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

TEST(OpenArea, SegmentIsLinear)
{
    EXPECT_EQ(openSegment(1, 2), 1);
    EXPECT_EQ(openSegment(-1, -2), 0);
    EXPECT_NEAR(openSegment(1, -3), 0.25, 1e-15);
    EXPECT_NEAR(openSegment(-3, 1), 0.25, 1e-15);
}


TEST(OpenArea, ExactlyOpenOrClosedAtTheLimits)
{
    EXPECT_EQ(openSegment(0, 2), 1);
    EXPECT_EQ(openSegment(0, -2), 0);
    EXPECT_EQ(openSegment(0, 0), 0);
    EXPECT_EQ(openTriangle(0, 0, 1), 1);
    EXPECT_EQ(openTriangle(0, -1, 0), 0);
    EXPECT_EQ(openTriangle(0, 0, 0), 0);
    EXPECT_EQ(openSquare({0.0, 0.0, 1.0, 2.0}), 1);
    EXPECT_EQ(openSquare({0.0, 0.0, -1.0, -2.0}), 0);
    EXPECT_EQ(openSquare({3.0, 1.0, 1.0, 1e-30}), 1);
    EXPECT_EQ(openSquare({-3.0, -1.0, -1.0, -1e-30}), 0);
    EXPECT_LT(openSquare({1.0, 1.0, 1.0, -1e-3}), 1);
    EXPECT_GT(openSquare({-1.0, -1.0, -1.0, 1e-3}), 0);
}


TEST(OpenArea, TriangleMatchesItsCutTips)
{
    // One corner open: a similar triangle of a quarter
    EXPECT_NEAR(openTriangle(1, -1, -1), 0.25, 1e-15);
    EXPECT_NEAR(openTriangle(-1, 1, -1), 0.25, 1e-15);
    EXPECT_NEAR(openTriangle(1, 1, -1), 0.75, 1e-15);
    EXPECT_NEAR(openTriangle(1, 0, -1), 0.5, 1e-15);
    EXPECT_NEAR(openTriangle(2, -1, -4), 2.0/3*2/6, 1e-15);
    EXPECT_NEAR(openTriangle(2, 1, -1), 1 - 1.0/3*1/2, 1e-15);
}


TEST(OpenArea, PlanarWallIsExactOnASquare)
{
    // phi = x - s on the unit square
    for (const scalar s : {0.0, 0.1, 0.5, 0.73, 1.0})
    {
        EXPECT_NEAR(openSquare({-s, 1 - s, 1 - s, -s}), 1 - s, 1e-14);
    }
    // phi = x + y - s: the part beyond a slanting line
    for (const scalar s : {0.2, 0.7, 1.0, 1.4, 1.9})
    {
        const scalar exact = s < 1 ? 1 - 0.5*sqr(s) : 0.5*sqr(2 - s);
        EXPECT_NEAR(openSquare({-s, 1 - s, 2 - s, 1 - s}), exact, 1e-14);
    }
}


TEST(OpenArea, OppositePartsFillTheSquare)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<scalar> random(-1, 1);
    for (label trial = 0; trial < 1000; ++trial)
    {
        FixedList<scalar, 4> phi, opposite;
        forAll(phi, i)
        {
            phi[i] = random(generator);
            opposite[i] = -phi[i];
        }
        EXPECT_NEAR(openSquare(phi) + openSquare(opposite), 1, 1e-13);
    }
}


TEST(OpenArea, RisesWithEachCorner)
{
    std::mt19937 generator(4);
    std::uniform_real_distribution<scalar> random(-1, 1);
    label nRisen = 0;
    for (label trial = 0; trial < 2000; ++trial)
    {
        FixedList<scalar, 4> phi;
        for (scalar& value : phi)
        {
            value = random(generator);
        }
        const scalar square = openSquare(phi);
        const scalar triangle = openTriangle(phi[0], phi[1], phi[2]);
        const scalar segment = openSegment(phi[0], phi[1]);
        phi[trial % 2] += mag(random(generator));

        EXPECT_GE(openSquare(phi), square - 1e-15);
        EXPECT_GE(openTriangle(phi[0], phi[1], phi[2]), triangle - 1e-15);
        EXPECT_GE(openSegment(phi[0], phi[1]), segment - 1e-15);
        nRisen += openSquare(phi) > square;
    }
    EXPECT_GT(nRisen, 1000);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
