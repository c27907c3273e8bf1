// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "nodesInside.H"
#include "samples/surfaceSamples.H"

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Number of nodes of a sphere of radius 1 at the origin in another sphere
label expected(const surfaceSet& surfaces, const point& c, const scalar r)
{
    label n = 0;
    for (label i = 0; i < surfaces.pointStart()[1]; ++i)
    {
        n += mag(surfaces.points()[i] - c) < r;
    }
    return n;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(nodesInside, areThoseOfMembranesInOtherObjects)
{
    // Far finer than the first, so that its triangles are a sphere
    surfaceSet surfaces(3);
    const point centre(0.61, 0.83, -0.47);
    appendSphere(surfaces, point(0, 0, 0), 1, 3);
    appendSphere(surfaces, centre, 0.9, 5);
    const label n = expected(surfaces, centre, 0.9);
    EXPECT_GT(n, 10);
    EXPECT_EQ(nodesInside(surfaces, vector::zero).ofMembranes, 0);
    surfaces.setImmersed(0, true);
    const insideCounts counts(nodesInside(surfaces, vector::zero));
    EXPECT_EQ(counts.ofMembranes, n);
    EXPECT_GT(counts.ofOthers, 10);
}


TEST(nodesInside, areThoseOfBodiesInMembranes)
{
    // The second is the membrane
    surfaceSet surfaces(3);
    const point centre(0.61, 0.83, -0.47);
    appendSphere(surfaces, point(0, 0, 0), 1, 3);
    appendSphere(surfaces, centre, 0.9, 5);
    surfaces.setImmersed(1, true);
    const insideCounts counts(nodesInside(surfaces, vector::zero));
    EXPECT_EQ(counts.ofOthers, expected(surfaces, centre, 0.9));
    EXPECT_GT(counts.ofMembranes, 10);
}


TEST(nodesInside, areFoundAcrossCyclicSides)
{
    surfaceSet surfaces(3);
    const point centre(0.61, 0.83, -0.47);
    const vector period(5, 0, 4);
    appendSphere(surfaces, point(0, 0, 0), 1, 3);
    appendSphere(surfaces, centre + vector(-5, 0, 4), 0.9, 5);
    surfaces.setImmersed(0, true);
    EXPECT_EQ
    (
        nodesInside(surfaces, period).ofMembranes,
        expected(surfaces, centre, 0.9)
    );
    EXPECT_EQ(nodesInside(surfaces, vector(5, 0, 0)).ofMembranes, 0);
}


// ************************************************************************* //
