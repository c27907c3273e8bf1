// SPDX-License-Identifier: GPL-3.0-or-later

#include "contact/searchCases.H"
#include "samples/surfaceSamples.H"
#include "surfaceWinding.H"

// * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * * //

TEST(SurfaceWinding, isOneInsideAndZeroOutside)
{
    surfaceSet plane(2);
    appendDisc(plane, point(3, 1, 0), 0.3, 11);
    appendDisc(plane, point(0.2, -0.1, 0), 1, 400);
    const surfaceSet solids(octahedra(1));

    randomNumbers random(5);
    label nInside = 0;
    for (label i = 0; i < 500; ++i)
    {
        const vector p
        (
            3*(random.sample01<vector>() - vector::uniform(0.5))
        );
        const point q(p.x(), p.y(), 0);
        const label turns = turnsAround(plane, 1, q);
        EXPECT_EQ(windingNumber(plane, 1, q), turns) << i;
        EXPECT_EQ(contains(plane, 1, q), turns != 0) << i;
        nInside += turns != 0;

        // |x| + |y| + |z| < 1, wherever it was moved to
        const point centre(solids.centroid(0));
        const scalar size = cmptSum(cmptMag(p));
        EXPECT_NEAR
        (
            windingNumber(solids, 0, centre + p),
            size < 1 ? 1 : 0,
            1e-9
        ) << i;
    }
    EXPECT_GT(nInside, 100);
}


TEST(SurfaceWinding, aFoldTurnsTheOtherWay)
{
    const surfaceSet surfaces(foldedBar());
    EXPECT_EQ(windingNumber(surfaces, 0, point(1, 0.5, 0)), 1);
    EXPECT_EQ(windingNumber(surfaces, 0, point(3.45, 0.5, 0)), -1);
    EXPECT_EQ(windingNumber(surfaces, 0, point(3.6, 0.5, 0)), 0);
    EXPECT_EQ(windingNumber(surfaces, 0, point(3.25, 0.9, 0)), 0);
    EXPECT_TRUE(contains(surfaces, 0, point(3.45, 0.5, 0)));
}


// ************************************************************************* //
