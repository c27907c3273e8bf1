// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>
#include <random>

#include "surfacePredicates.H"
#include "samples/surfaceSamples.H"
#include "openfoamVersion.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- The corners of an octahedron of radius 1 about a point
surfaceSet octahedra(const List<point>& centres)
{
    surfaceSet surfaces(3);
    for (const point& x : centres)
    {
        appendSphere(surfaces, x, 1, 0);
    }
    return surfaces;
}


List<labelPair> overlaps
(
    const List<point>& centres,
    const vector& period = Zero
)
{
    return surfacePredicates::overlapping
    (
        octahedra(centres), identityList(centres.size()), period
    );
}

} // End anonymous namespace


TEST(SurfacePredicates, solidsOverlapTouchOrDoNot)
{
    const point origin(0, 0, 0);
    const List<labelPair> one(1, labelPair(0, 1));
    EXPECT_EQ(overlaps({origin, {1.9, 0, 0}}), one);
    EXPECT_EQ(overlaps({origin, {0.6, 0.6, 0.6}}), one);

    // Corner on corner, and the next number beyond
    EXPECT_EQ(overlaps({origin, {2, 0, 0}}), one);
    const scalar beyond = std::nextafter(2.0, 3.0);
    EXPECT_EQ(overlaps({origin, {beyond, 0, 0}}).size(), 0);

    // Boxes overlap, octahedra do not
    EXPECT_EQ(overlaps({origin, {0.7, 0.7, 0.7}}).size(), 0);
}


TEST(SurfacePredicates, solidsEncloseEachOther)
{
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 1);
    appendSphere(surfaces, point(5, 0, 0), 1, 1);
    appendSphere(surfaces, point(0.1, 0, 0), 0.3, 1);
    const List<labelPair> expected(1, labelPair(0, 2));
    EXPECT_EQ
    (
        surfacePredicates::overlapping(surfaces, identityList(3)), expected
    );
    EXPECT_EQ
    (
        surfacePredicates::overlapping(surfaces, labelList({1, 2})).size(), 0
    );
}


TEST(SurfacePredicates, solidsMeetAcrossSeams)
{
    const pointField centres({{0.2, 0, 9.9}, {9.1, 5, 0.1}, {5, 5, 5}});
    EXPECT_EQ(overlaps(centres).size(), 0);
    EXPECT_EQ(overlaps(centres, vector(10, 0, 10)).size(), 0);
    const List<labelPair> expected(1, labelPair(0, 1));
    EXPECT_EQ(overlaps(centres, vector(10, 5, 10)), expected);

    // However many periods away
    EXPECT_EQ
    (
        overlaps
        (
            {{0.2, 0, 39.9}, {-20.9, 5, 0.1}}, vector(10, 5, 10)
        ),
        expected
    );
}


TEST(SurfacePredicates, wallsThroughThePeriodAreWhereTheyAre)
{
    // A solid that is longer than the period meets another one only where both
    // are, and not its images
    surfaceSet surfaces(3);
    appendSphere(surfaces, point(0.5, 0, 0), 6, 1);
    appendSphere(surfaces, point(7, 0, 0), 0.3, 1);
    appendSphere(surfaces, point(0.5, 2, 0), 0.3, 1);
    const List<labelPair> expected(1, labelPair(0, 2));
    EXPECT_EQ
    (
        surfacePredicates::overlapping
        (
            surfaces, identityList(3), vector(8, 0, 0)
        ),
        expected
    );
}


TEST(SurfacePredicates, pairsAreThoseOfACompleteSearch)
{
    std::mt19937 engine(7);
    std::uniform_real_distribution<scalar> place(0, 8);
    pointField centres(60);
    for (point& x : centres)
    {
        x = point(place(engine), place(engine), place(engine));
    }

    // Two octahedra meet where their Minkowski sum holds the distance
    const vector period(8, 0, 8);
    DynamicList<labelPair> expected;
    forAll(centres, i)
    {
        for (label j = i + 1; j < centres.size(); ++j)
        {
            scalar sum = 0;
            for (direction d = 0; d < 3; ++d)
            {
                const scalar apart = mag(centres[i][d] - centres[j][d]);
                sum += period[d] > 0 ? min(apart, period[d] - apart) : apart;
            }
            if (sum <= 2)
            {
                expected.append(labelPair(i, j));
            }
        }
    }
    EXPECT_GT(expected.size(), 20);
    EXPECT_EQ(overlaps(centres, period), List<labelPair>(expected));
}


TEST(SurfacePredicates, noticesSurfacesThatCutThemselves)
{
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 2);
    EXPECT_FALSE(surfacePredicates::cutsItself(surfaces, 0));

    // A node beyond the other side
    surfaceSet folded(surfaces);
    folded.points()[0] *= -1.5;
    EXPECT_TRUE(surfacePredicates::cutsItself(folded, 0));

    // A triangle is missing
    surfaceSet open(3);
    List<surfaceFace> faces(surfaces.faces());
    faces.resize(faces.size() - 1);
    open.append(surfaces.points(), faces);
    EXPECT_TRUE(surfacePredicates::cutsItself(open, 0));
}


TEST(SurfacePredicates, outlinesAreThoseOfPolygonPredicates)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0, 0, 0), 1, 30);
    appendDisc(surfaces, point(9.5, 0, 0), 1, 30);
    EXPECT_FALSE(surfacePredicates::cutsItself(surfaces, 0));
    EXPECT_TRUE
    (
        surfacePredicates::overlapping(surfaces, identityList(2)).empty()
    );
    EXPECT_EQ
    (
        surfacePredicates::overlapping
        (
            surfaces, identityList(2), vector(10, 0, 0)
        ),
        List<labelPair>(1, labelPair(0, 1))
    );
    surfaces.points()[0] *= -2;
    EXPECT_TRUE(surfacePredicates::cutsItself(surfaces, 0));
}


// ************************************************************************* //
