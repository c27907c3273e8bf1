// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "edgeCuts.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Corners of a unit square around its face, and of a segment
static const FixedList<point, 4> square
({
    point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)
});


TEST(EdgeCuts, OfASegmentIsOne)
{
    const edgeCuts cuts({1.0, -3.0, 1.0, -3.0}, square, 2);
    EXPECT_EQ(cuts.n, 1);
    EXPECT_NEAR(mag(cuts.middle() - point(0.25, 0, 0)), 0, 1e-15);
    EXPECT_EQ(edgeCuts({1.0, 3.0, -1.0, -3.0}, square, 2).n, 0);
}


TEST(EdgeCuts, OfASquareEndOnTheWall)
{
    // The plane x + y/2 = 0.75
    const edgeCuts cuts({0.75, -0.25, -0.75, 0.25}, square, 4);
    EXPECT_EQ(cuts.n, 2);
    EXPECT_NEAR(mag(cuts.at[0] - point(0.75, 0, 0)), 0, 1e-15);
    EXPECT_NEAR(mag(cuts.at[1] - point(0.25, 1, 0)), 0, 1e-15);
    EXPECT_NEAR(mag(cuts.middle() - point(0.5, 0.5, 0)), 0, 1e-15);
}


TEST(EdgeCuts, OfTwoCornersAreFour)
{
    const edgeCuts cuts({1.0, -1.0, 1.0, -1.0}, square, 4);
    EXPECT_EQ(cuts.n, 4);
    EXPECT_NEAR(mag(cuts.middle() - point(0.5, 0.5, 0)), 0, 1e-15);
}


TEST(EdgeCuts, OfAWholeFaceAreNone)
{
    EXPECT_EQ(edgeCuts({1.0, 2.0, 3.0, 4.0}, square, 4).n, 0);
    EXPECT_EQ(edgeCuts({-1.0, 0.0, -3.0, -4.0}, square, 4).n, 0);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
