// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "medialAxis.H"
#include "samples/surfaceSamples.H"

#include <limits>
#include <set>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The pairs of objects among the points
static std::set<std::pair<label, label>> pairsOf(const medialAxis& axis)
{
    std::set<std::pair<label, label>> pairs;
    for (const medialAxisPoint& p : axis.points())
    {
        EXPECT_LT(p.object[0], p.object[1]);
        pairs.insert(std::make_pair(p.object[0], p.object[1]));
    }
    return pairs;
}


TEST(MedialAxis, LiesHalfWayBetweenTwoDiscs)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 100, 2));
    const scalar h = block.spacing();
    // Gaps from far below a spacing to just below the contact distance
    for (const scalar gap : {0.1, 0.7, 1.5, 2.9})
    {
        surfaceSet surfaces(2);
        const scalar offset = 0.4 + 0.5*gap*h;
        appendDisc(surfaces, point(0.0137 - offset, 0, 0), 0.4, 400);
        appendDisc(surfaces, point(0.0137 + offset, 0, 0), 0.4, 400);

        medialAxis axis(3*h, h);
        axis.update(surfaces, block);
        ASSERT_GT(axis.points().size(), 0);
        for (const medialAxisPoint& p : axis.points())
        {
            EXPECT_NEAR(p.position.x(), 0.0137, 0.6*h);
            EXPECT_LT(mag(p.position.y()), 0.3);
            EXPECT_EQ(p.object[0], 0);
            EXPECT_EQ(p.object[1], 1);
            const scalar exact =
                mag(p.position - point(0.0137 + offset, 0, 0)) - 0.4;
            EXPECT_NEAR(p.distance, exact, h);
            EXPECT_LT(exact, 1.5*h + h);
        }
    }
}


TEST(MedialAxis, NothingBeyondTheContactDistance)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 100, 2));
    const scalar h = block.spacing();
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(-0.4 - 2.1*h, 0, 0), 0.4, 400);
    appendDisc(surfaces, point(0.4 + 2.1*h, 0, 0), 0.4, 400);
    medialAxis axis(3*h, h);
    axis.update(surfaces, block);
    EXPECT_TRUE(axis.points().empty());

    // A larger contact distance finds more
    medialAxis wider(5*h, h);
    wider.update(surfaces, block);
    EXPECT_GT(wider.points().size(), 0);

    // No surface at all
    axis.update(surfaceSet(2), block);
    EXPECT_TRUE(axis.points().empty());
}


TEST(MedialAxis, FindsEveryPairOfALattice)
{
    // 4 x 3 discs: neighbours in rows and columns touch, diagonals do not
    const cartesianBlock block(cellCentres(point::zero, 4, 160, 2));
    const scalar h = block.spacing();
    surfaceSet surfaces(2);
    for (label j = 0; j < 3; ++j)
    {
        for (label i = 0; i < 4; ++i)
        {
            appendDisc
            (
                surfaces, point(0.5 + i, 0.5 + j, 0), 0.5 - 0.75*h, 90
            );
        }
    }
    medialAxis axis(3*h, h);
    axis.update(surfaces, block);
    const auto pairs = pairsOf(axis);
    EXPECT_EQ(pairs.size(), 17u);
    for (const auto& pair : pairs)
    {
        const label step = pair.second - pair.first;
        EXPECT_TRUE(step == 1 || step == 4);
        EXPECT_TRUE(step != 1 || pair.first % 4 < 3);
    }
}


// Two tips of a star reach one arm's notch: two separate contacts
TEST(MedialAxis, NonConvexObjectsTouchInSeveralPlaces)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 160, 2));
    const scalar h = block.spacing();
    surfaceSet surfaces(2);
    // A comb opening upwards, and a comb with two teeth coming down
    appendPolygon
    (
        surfaces,
        pointField
        ({
            {-0.6, -0.8, 0}, {0.6, -0.8, 0}, {0.6, 0, 0}, {0.4, 0, 0},
            {0.4, -0.6, 0}, {-0.4, -0.6, 0}, {-0.4, 0, 0}, {-0.6, 0, 0}
        })
    );
    const scalar gap = 1.2*h;
    const scalar tip = -0.6 + gap;
    appendPolygon
    (
        surfaces,
        pointField
        ({
            {-0.3, tip, 0}, {-0.2, tip, 0}, {-0.2, 0.4, 0}, {0.2, 0.4, 0},
            {0.2, tip, 0}, {0.3, tip, 0}, {0.3, 0.7, 0}, {-0.3, 0.7, 0}
        })
    );
    medialAxis axis(3*h, h);
    axis.update(surfaces, block);
    EXPECT_EQ(pairsOf(axis).size(), 1u);

    label nLeft = 0, nRight = 0;
    for (const medialAxisPoint& p : axis.points())
    {
        EXPECT_NEAR(p.position.y(), -0.6 + 0.5*gap, 2*h);
        EXPECT_GT(mag(p.position.x()), 0.2 - 2*h);
        EXPECT_LT(mag(p.position.x()), 0.3 + 2*h);
        (p.position.x() < 0 ? nLeft : nRight) += 1;
    }
    EXPECT_GE(nLeft, 6);
    EXPECT_GE(nRight, 6);
}


TEST(MedialAxis, LiesHalfWayBetweenTwoSpheres)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 40, 3));
    const scalar h = block.spacing();
    surfaceSet surfaces(3);
    appendSphere(surfaces, point(0, 0, -0.4 - 0.6*h), 0.4, 3);
    appendSphere(surfaces, point(0, 0, 0.4 + 0.6*h), 0.4, 3);
    medialAxis axis(3*h, h);
    axis.update(surfaces, block);
    EXPECT_GT(axis.points().size(), 4);
    for (const medialAxisPoint& p : axis.points())
    {
        EXPECT_NEAR(p.position.z(), 0, h);
        EXPECT_LT(sqr(p.position.x()) + sqr(p.position.y()), sqr(0.45));
    }
}


TEST(MedialAxis, TakesALevelSetMadeElsewhere)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 100, 2));
    const scalar h = block.spacing();
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(-0.4 - 0.5*h, 0, 0), 0.4, 400);
    appendDisc(surfaces, point(0.4 + 0.5*h, 0, 0), 0.4, 400);
    surfaceDistance rebuilt(4*h);
    rebuilt.update(surfaces, block);

    medialAxis axis(3*h, h);
    axis.update(block, rebuilt.distance(), rebuilt.object());
    ASSERT_GT(axis.points().size(), 6);
    for (const medialAxisPoint& p : axis.points())
    {
        EXPECT_NEAR(p.position.x(), 0, 1e-3*h);
        EXPECT_LT(p.distance, 2*h);
    }
}


TEST(MedialAxis, RefusesBadInput)
{
    EXPECT_THROW(medialAxis(0, 0.1), error);
    EXPECT_THROW(medialAxis(-1, 0.1), error);
    EXPECT_THROW(medialAxis(0.1, 0), error);

    const cartesianBlock block(cellCentres(-point::one, 2, 50, 2));
    surfaceSet surfaces(2);
    appendDisc(surfaces, point::zero, 0.4, 40);
    surfaces.points()[0].x() = std::numeric_limits<scalar>::quiet_NaN();
    medialAxis axis(0.1, block.spacing());
    EXPECT_THROW(axis.update(surfaces, block), error);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
