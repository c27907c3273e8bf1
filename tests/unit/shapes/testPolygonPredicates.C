// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "openfoamVersion.H"
#include "polygonPredicates.H"
#include "surfacePredicates.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

pointField square(const scalar x, const scalar y, const scalar a)
{
    return pointField
    ({
        point(x, y, 0), point(x + a, y, 0),
        point(x + a, y + a, 0), point(x, y + a, 0)
    });
}


//- A C that opens to the right, of outer size 3 and arms 1 wide
pointField letterC()
{
    return pointField
    ({
        {0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0},
        {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}
    });
}


void expectOverlap(const pointField& a, const pointField& b, const bool answer)
{
    pointField clockwise(b);
    std::reverse(clockwise.begin(), clockwise.end());
    EXPECT_EQ(polygonPredicates::overlap(a, b), answer);
    EXPECT_EQ(polygonPredicates::overlap(b, a), answer);
    EXPECT_EQ(polygonPredicates::overlap(a, clockwise), answer);
}

List<labelPair> overlapping
(
    const List<pointField>& polygons,
    const vector& period = Zero
)
{
    surfaceSet surfaces(2);
    for (const pointField& polygon : polygons)
    {
        List<surfaceFace> sides(polygon.size());
        forAll(sides, i)
        {
            sides[i] = surfaceFace({i, (i + 1) % polygon.size(), -1});
        }
        surfaces.append(polygon, sides);
    }
    return surfacePredicates::overlapping
    (
        surfaces, identityList(polygons.size()), period
    );
}

} // End anonymous namespace


TEST(PolygonPredicates, overlapTouchAndEnclosure)
{
    const pointField one(square(0, 0, 1));
    expectOverlap(one, square(0.9, 0.9, 1), true);
    expectOverlap(one, square(0.4, 0.4, 0.1), true);
    expectOverlap(one, square(-1, -1, 3), true);
    expectOverlap(one, one, true);
    expectOverlap(one, square(1, 0, 1), true);
    expectOverlap(one, square(1, 1, 1), true);
    expectOverlap(one, square(2, 2, 1), false);

    // The next number beyond the side
    const scalar beyond = std::nextafter(1.0, 2.0);
    expectOverlap(one, square(beyond, 0, 1), false);
}


TEST(PolygonPredicates, notchesAreOutside)
{
    expectOverlap(letterC(), square(1.5, 1.25, 0.5), false);
    expectOverlap(letterC(), square(1.5, 1.25, 0.75), true);
    expectOverlap(letterC(), square(0.25, 1.25, 0.5), true);
}


TEST(PolygonPredicates, crossingPolygonsAreNotSimple)
{
    EXPECT_TRUE(polygonPredicates::isSimple(letterC()));
    pointField folded(letterC());
    folded[5].y() = 0.5;
    EXPECT_FALSE(polygonPredicates::isSimple(folded));
}


TEST(PolygonPredicates, findsAllPairs)
{
    const List<pointField> polygons
    ({
        square(0, 0, 1), square(5, 5, 1), square(0.5, 0.5, 1),
        square(1.4, 1.4, 1), square(5.2, 5.2, 0.1)
    });
    const List<labelPair> expected({{0, 2}, {1, 4}, {2, 3}});
    EXPECT_EQ(overlapping(polygons), expected);
}


TEST(PolygonPredicates, seesAcrossThePeriod)
{
    // In a box of 10 that repeats in x, also for positions not folded into it
    const List<pointField> polygons
    ({
        square(9.5, 0, 1), square(0.25, 0.5, 1), square(-0.25, 3, 1),
        square(29.5, 3.5, 1), square(9.75, 9.5, 1)
    });
    const List<labelPair> expected({{0, 1}, {2, 3}});
    EXPECT_EQ(overlapping(polygons, vector(10, 0, 0)), expected);

    const List<labelPair> inBoth({{0, 1}, {0, 4}, {1, 4}, {2, 3}});
    EXPECT_EQ(overlapping(polygons, vector(10, 10, 0)), inBoth);
    EXPECT_EQ(overlapping(polygons).size(), 0);
}


// ************************************************************************* //
