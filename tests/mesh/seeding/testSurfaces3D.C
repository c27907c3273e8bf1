// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"
#include "randomNumbers.H"
#include "rotations.H"

using namespace Foam;
using Foam::fsi::closedSurface;
using Foam::fsi::packing;
using Foam::fsi::placedObject;
using Foam::fsi::surfaceFace;

namespace
{

//- The twelve triangles of a box
closedSurface box(const point& low, const point& high)
{
    pointField points(8);
    for (label i = 0; i < 8; ++i)
    {
        points[i] = point
        (
            i & 1 ? high.x() : low.x(),
            i & 2 ? high.y() : low.y(),
            i & 4 ? high.z() : low.z()
        );
    }
    return closedSurface
    (
        points,
        List<surfaceFace>
        ({
            {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
            {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
            {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}
        })
    );
}

} // End namespace


TEST(ClosedSurface, boxesAreAtTheirExactDistance)
{
    const closedSurface cube = box({0, 0, 0}, {1, 1, 1});
    EXPECT_DOUBLE_EQ(cube.volume(), 1);

    // Face to face, edge to edge, corner to corner
    const auto gap = [&](const point& low)
    {
        return cube.distance(box(low, low + vector(2, 3, 4)));
    };
    EXPECT_NEAR(gap({1.25, 0.5, 0.2}), 0.25, 1e-14);
    EXPECT_NEAR(gap({1.3, 1.4, 0.2}), 0.5, 1e-14);
    EXPECT_NEAR(gap({1.2, 1.3, 1.6}), 0.7, 1e-14);

    // Crossed edges: a bar over the edge of the cube, turned about x by 45
    // degrees, touches it with its own edge at the height sqrt(2)
    const closedSurface bar = box({-1, -1, -1}, {1, 1, 1}).moved
    (
        fsi::rotationAbout({1, 0, 0}, 45), {0.5, 0.5, 1 + Foam::sqrt(2.0)}
    );
    EXPECT_NEAR(cube.distance(bar), 0, 1e-14);
    EXPECT_NEAR
    (
        cube.distance(bar.moved(tensor::I, {0, 0, 0.3})), 0.3, 1e-14
    );
    EXPECT_NEAR
    (
        bar.moved(tensor::I, {0, 0, 0.3}).distance(cube), 0.3, 1e-14
    );
}


TEST(ClosedSurface, crossedAndEnclosedOnesAreAtDistanceZero)
{
    const closedSurface cube = box({0, 0, 0}, {1, 1, 1});
    for
    (
        const closedSurface& other :
        {
            box({0.2, 0.6, -1}, {0.3, 0.8, 2}),
            box({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}),
            box({0.9, 0.9, 0.9}, {2, 2, 2})
        }
    )
    {
        EXPECT_EQ(cube.distance(other), 0);
        EXPECT_EQ(other.distance(cube), 0);
        EXPECT_TRUE(cube.closerThan(other, 0));
        EXPECT_TRUE(other.closerThan(cube, 0));
    }
}


TEST(ClosedSurface, closerThanAgreesWithDistance)
{
    fsi::randomNumbers random(3);
    const closedSurface flat = seedBox::ellipsoid({1, 1, 0.2}, 2);
    label nClose = 0;
    for (label i = 0; i < 200; ++i)
    {
        const closedSurface moved = flat.moved
        (
            fsi::randomRotation(random, 3),
            3*random.sample01<vector>() - vector(1.5, 1.5, 1.5)
        );
        const scalar gap = 0.2*random.sample01<scalar>();
        const bool close = flat.closerThan(moved, gap);
        EXPECT_EQ(close, flat.distance(moved) <= gap) << i;
        nClose += close;
    }
    EXPECT_GT(nClose, 30);
    EXPECT_LT(nClose, 170);
}


TEST(Packing, findsInSpaceWhatACompleteSearchFinds)
{
    packing space
    (
        boundBox(point(0, 0, 0), point(9, 6, 7)), 0.1, {"flat", "long"},
        {
            seedBox::ellipsoid({1, 1, 0.3}, 1),
            seedBox::ellipsoid({0.2, 0.2, 2}, 1)
        },
        vector(9, 0, 0)
    );
    fsi::randomNumbers random(4);
    const auto next = [&](const label shape)
    {
        placedObject object;
        object.shape = shape;
        object.centre =
            cmptMultiply(random.sample01<vector>(), vector(9, 6, 7));
        object.rotation = fsi::randomRotation(random, 3);
        return object;
    };
    for (label i = 0; i < 25; ++i)
    {
        space.insert(next(i % 2));
    }
    label nFound = 0;
    for (label i = 0; i < 100; ++i)
    {
        const placedObject object(next(0));
        const closedSurface candidate = space.placed(object);
        const scalar gap = 0.2*random.sample01<scalar>();
        label nClose = 0;
        for (label j = 0; j < space.size(); ++j)
        {
            nClose += space.distance(candidate, j) <= gap;
        }
        const label found = space.findConflict(object, gap);
        EXPECT_EQ(found >= 0, nClose > 0) << i;
        nFound += found >= 0;
    }
    EXPECT_GT(nFound, 10);
    EXPECT_LT(nFound, 90);
}


TEST(Rotations, randomOnesAreEvenAmongAll)
{
    // An even distribution has the mean 0 of R and 1/3 of R_ij^2
    fsi::randomNumbers random(1);
    const label n = 20000;
    tensor mean(Zero), meanSqr(Zero);
    scalar meanAngle = 0;
    for (label i = 0; i < n; ++i)
    {
        const tensor R(fsi::randomRotation(random, 3));
        mean += R/n;
        meanSqr += cmptMultiply(R, R)/n;
        meanAngle += std::acos(0.5*(tr(R) - 1))/n;
        ASSERT_NEAR(det(R), 1, 1e-12);
        ASSERT_LT(mag((R & R.T()) - tensor::I), 1e-12);
    }

    // Five standard deviations; the density of angles is (1 - cos a)/pi
    const scalar five = 5/Foam::sqrt(scalar(n));
    EXPECT_LT(cmptMax(cmptMag(mean)), five*Foam::sqrt(1/3.0));
    EXPECT_LT(cmptMax(cmptMag(meanSqr - tensor::one/3)), five*0.3);
    EXPECT_NEAR(meanAngle, 0.5*M_PI + 2/M_PI, five*0.65);
}


// ************************************************************************* //
