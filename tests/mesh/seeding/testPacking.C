// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"
#include "outlineLoop.H"
#include "randomNumbers.H"

using namespace Foam;
using Foam::fsi::closedSurface;
using Foam::fsi::packing;
using Foam::fsi::placedObject;
using seedBox::rotation;

namespace
{

//- Outline of a rectangle
closedSurface rectangle(const point& low, const point& high)
{
    return seedBox::outline
    (
        pointField
        ({
            low, {high.x(), low.y(), 0}, high, {low.x(), high.y(), 0}
        })
    );
}


//- A square ring with a gap of 0.2 on its right side (a letter C)
closedSurface letterC()
{
    return seedBox::outline
    (
        pointField
        ({
            {0, 0, 0}, {1, 0, 0}, {1, 0.4, 0}, {0.9, 0.4, 0}, {0.9, 0.1, 0},
            {0.1, 0.1, 0}, {0.1, 0.9, 0}, {0.9, 0.9, 0}, {0.9, 0.6, 0},
            {1, 0.6, 0}, {1, 1, 0}, {0, 1, 0}
        })
    );
}

} // End namespace


TEST(Outline, distanceIsExact)
{
    const closedSurface square = rectangle({0, 0, 0}, {1, 1, 0});

    // Side to side, corner to corner, and corner to side
    EXPECT_DOUBLE_EQ
    (
        square.distance(rectangle({1.25, 0.5, 0}, {2, 3, 0})), 0.25
    );
    EXPECT_DOUBLE_EQ
    (
        square.distance(rectangle({1.3, 1.4, 0}, {2, 3, 0})), 0.5
    );
    const closedSurface tilted =
        rectangle({-1, -1, 0}, {1, 1, 0}).moved(rotation(45), {3, 0.5, 0});
    EXPECT_NEAR(square.distance(tilted), 2 - Foam::sqrt(2.0), 1e-14);
    EXPECT_NEAR(tilted.distance(square), 2 - Foam::sqrt(2.0), 1e-14);
}


TEST(Outline, crossingAndEnclosedOutlinesAreAtDistanceZero)
{
    const closedSurface square = rectangle({0, 0, 0}, {1, 1, 0});
    const closedSurface cross = rectangle({0.4, -1, 0}, {0.6, 2, 0});
    const closedSurface inner = rectangle({0.4, 0.4, 0}, {0.6, 0.6, 0});

    for (const closedSurface& other : {cross, inner})
    {
        EXPECT_EQ(square.distance(other), 0);
        EXPECT_EQ(other.distance(square), 0);
        EXPECT_TRUE(square.closerThan(other, 0));
        EXPECT_TRUE(other.closerThan(square, 0));
    }
    EXPECT_TRUE(square.closerThan(square, 0));
}


TEST(Outline, aBodyMayLieInTheHollowOfAnother)
{
    const closedSurface hollow = letterC();
    const closedSurface inner = rectangle({0.4, 0.4, 0}, {0.6, 0.6, 0});
    EXPECT_NEAR(hollow.distance(inner), 0.3, 1e-14);
    EXPECT_FALSE(hollow.closerThan(inner, 0.29));
    EXPECT_TRUE(hollow.closerThan(inner, 0.31));
}


TEST(Outline, closerThanAgreesWithDistance)
{
    fsi::randomNumbers random(5);
    label nClose = 0;
    for (label i = 0; i < 300; ++i)
    {
        const closedSurface moved = letterC().moved
        (
            rotation(360*random.sample01<scalar>()),
            4*random.sample01<vector>() - vector(2, 2, 0)
        );
        const scalar gap = 0.3*random.sample01<scalar>();
        const bool close = letterC().closerThan(moved, gap);
        EXPECT_EQ(close, letterC().distance(moved) <= gap) << i;
        nClose += close;
    }
    EXPECT_GT(nClose, 50);
    EXPECT_LT(nClose, 250);
}


TEST(Outline, loopFollowsSegmentsInAnyOrder)
{
    const List<fsi::surfaceFace> segments
    ({
        fsi::surfaceFace({4, 7, -1}),
        fsi::surfaceFace({2, 4, -1}),
        fsi::surfaceFace({7, 2, -1})
    });
    fsi::surfaceSet surfaces(2);
    surfaces.append(pointField(3, Zero), List<fsi::surfaceFace>());
    surfaces.append(pointField(8, Zero), segments);
    EXPECT_EQ(fsi::outlineLoop(surfaces, 1), labelList({7, 10, 5}));
}


TEST(Packing, findsWhatACompleteSearchFinds)
{
    const boundBox domain(point(0, 0, 0), point(20, 10, 1));
    packing space
    (
        domain, 0.05, {"letter", "bar"},
        {letterC(), rectangle({-2, -0.1, 0}, {2, 0.1, 0})}
    );
    fsi::randomNumbers random(2);
    const auto next = [&](const label shape)
    {
        placedObject object;
        object.shape = shape;
        object.centre = cmptMultiply
        (
            random.sample01<vector>(), vector(22, 12, 0)
        ) - vector(1, 1, 0);
        object.rotation = rotation(360*random.sample01<scalar>());
        return object;
    };
    for (label i = 0; i < 60; ++i)
    {
        space.insert(next(i % 2));
    }

    // Objects that were moved must be found where they are now
    for (label i = 0; i < 20; ++i)
    {
        const placedObject to = next(space[i].shape);
        space.move(i, to);
    }

    label nFound = 0;
    for (label i = 0; i < 200; ++i)
    {
        const placedObject object(next(0));
        const closedSurface candidate = space.placed(object);
        const scalar gap = 0.2*random.sample01<scalar>();
        label nClose = 0;
        for (label j = 0; j < space.size(); ++j)
        {
            nClose += space.surface(j).distance(candidate) <= gap;
        }
        const label found = space.findConflict(object, gap);
        EXPECT_EQ(found >= 0, nClose > 0) << i;
        if (found >= 0)
        {
            EXPECT_LE(space.surface(found).distance(candidate), gap);
            ++nFound;
            if (nClose == 1)
            {
                EXPECT_EQ(space.findConflict(object, gap, found), -1);
            }
        }
    }
    EXPECT_GT(nFound, 30);
    EXPECT_LT(nFound, 190);
}


TEST(Packing, attachedObjectsMayReachOutOfTheDomain)
{
    const boundBox domain(point(0, 0, 0), point(2, 1, 1));
    const packing space
    (
        domain, 0.05, {"free", "attached"},
        {
            rectangle({-0.2, -0.1, 0}, {0.2, 0.1, 0}),
            rectangle({-0.2, -0.1, 0}, {0.2, 0.1, 0})
        },
        Zero, {false, true}
    );
    const auto fits = [&](const label shape, const point& x, const scalar gap)
    {
        placedObject object;
        object.shape = shape;
        object.centre = x;
        object.rotation = tensor::I;
        return space.inDomain(object, space.placed(object), gap);
    };
    for (const label shape : {0, 1})
    {
        const bool attached = shape == 1;
        EXPECT_TRUE(fits(shape, {1, 0.5, 0}, 0));
        EXPECT_EQ(fits(shape, {1, 0.05, 0}, 0), attached);
        EXPECT_EQ(fits(shape, {2.1, 1.05, 0}, 0), attached);
        EXPECT_FALSE(fits(shape, {1, 0.15, 0}, 0.1));
        EXPECT_FALSE(fits(shape, {1, -0.2, 0}, 0));
        EXPECT_FALSE(fits(shape, {2.3, 0.5, 0}, 0));
    }
}


// ************************************************************************* //
