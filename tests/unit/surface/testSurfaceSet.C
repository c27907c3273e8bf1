// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "samples/surfaceSamples.H"

#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

TEST(SurfaceSet, PolygonMeasuresAreExact)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(5, 5, 0), 1, 7);
    appendPolygon
    (
        surfaces,
        pointField({{1, 1, 0}, {4, 1, 0}, {4, 3, 0}, {1, 3, 0}})
    );

    ASSERT_EQ(surfaces.size(), 2);
    EXPECT_NEAR(surfaces.volume(1), 6, 1e-14);
    EXPECT_NEAR(surfaces.surfaceArea(1), 10, 1e-14);
    EXPECT_NEAR(mag(surfaces.centroid(1) - point(2.5, 2, 0)), 0, 1e-14);
    EXPECT_EQ(surfaces.pointStart()[1], 7);
    EXPECT_EQ(surfaces.faces()[7][0], 7);
    EXPECT_EQ(surfaces.faceObject()[7], 1);
    EXPECT_EQ(surfaces.pointObject()[6], 0);

    const scalar sector = constant::mathematical::twoPi/7;
    EXPECT_NEAR(surfaces.volume(0), 3.5*Foam::sin(sector), 1e-13);
    EXPECT_NEAR(mag(surfaces.centroid(0) - point(5, 5, 0)), 0, 1e-13);

    // Outward: the bottom side's normal points down
    EXPECT_NEAR(mag(surfaces.areaNormal(7) - vector(0, -3, 0)), 0, 1e-14);
    EXPECT_NEAR(surfaces.bounds(1).max().x(), 4, 0);

    surfaces.clear();
    EXPECT_EQ(surfaces.size(), 0);
    EXPECT_EQ(surfaces.points().size(), 0);
}


TEST(SurfaceSet, ManyAtOnceAreThoseOneByOne)
{
    for (const direction nDims : {2, 3})
    {
        surfaceSet model(nDims);
        if (nDims == 2)
        {
            appendDisc(model, point(5, 5, 0), 1, 7);
        }
        else
        {
            appendSphere(model, point(1, 2, 3), 2, 2);
        }
        surfaceSet one(model), many(model);
        for (label i = 0; i < 3; ++i)
        {
            EXPECT_EQ(one.append(model.points(), model.faces()), i + 1);
        }
        EXPECT_EQ(many.append(model.points(), model.faces(), 3), 1);
        EXPECT_EQ(many.append(model.points(), model.faces(), 0), 4);
        EXPECT_EQ(many.size(), 4);
        EXPECT_EQ(many.points(), one.points());
        EXPECT_EQ(many.velocities(), one.velocities());
        EXPECT_EQ(many.faces(), one.faces());
        EXPECT_EQ(many.faceObject(), one.faceObject());
        EXPECT_EQ(many.pointObject(), one.pointObject());
        EXPECT_EQ(many.pointStart(), one.pointStart());
        EXPECT_EQ(many.faceStart(), one.faceStart());
        EXPECT_FALSE(many.fixed(3));
        forAll(many.faces(), facei)
        {
            for (label i = 0; i < nDims; ++i)
            {
                EXPECT_EQ(many.faceAcross(facei, i), one.faceAcross(facei, i));
            }
        }
    }
}


TEST(SurfaceSet, SphereMeasuresConverge)
{
    const scalar pi = constant::mathematical::pi;
    scalar coarse = 0;
    for (const label nCuts : {3, 4})
    {
        surfaceSet surfaces(3);
        appendSphere(surfaces, point(1, 2, 3), 2, nCuts);
        const scalar error = 1 - surfaces.volume(0)/(32*pi/3);
        EXPECT_GT(error, 0);
        EXPECT_NEAR(mag(surfaces.centroid(0) - point(1, 2, 3)), 0, 1e-13);
        EXPECT_LT(surfaces.surfaceArea(0), 16*pi);
        if (nCuts == 4)
        {
            EXPECT_NEAR(coarse/error, 4, 0.2);
        }
        coarse = error;
    }
}


// No point of the face is nearer than the one found
TEST(SurfaceSet, NearestPointOfAFaceIsNearest)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<scalar> random(-1, 1);
    const auto randomPoint = [&](const direction nDims)
    {
        const scalar x = random(generator), y = random(generator);
        return point(x, y, nDims == 3 ? random(generator) : 0);
    };

    for (const direction nDims : {2, 3})
    {
        for (label trial = 0; trial < 200; ++trial)
        {
            surfaceSet surfaces(nDims);
            pointField nodes(nDims);
            for (point& node : nodes)
            {
                node = randomPoint(nDims);
            }
            surfaces.append
            (
                nodes,
                List<surfaceFace>(1, {0, 1, nDims == 3 ? 2 : -1})
            );
            const point p(2*randomPoint(nDims));

            FixedList<scalar, 3> w;
            const point nearest(surfaces.nearestOnFace(0, p, w));
            EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-12);
            EXPECT_GE(min(w[0], min(w[1], w[2])), 0);
            EXPECT_NEAR
            (
                mag(surfaces.interpolate(surfaces.points(), 0, w) - nearest),
                0,
                1e-14
            );

            const label n = 40;
            for (label i = 0; i <= n; ++i)
            {
                for (label j = 0; j <= (nDims == 3 ? n - i : 0); ++j)
                {
                    const scalar b = scalar(i)/n, c = scalar(j)/n;
                    point q((1 - b - c)*nodes[0] + b*nodes[1]);
                    q += nDims == 3 ? c*nodes[2] : vector::zero;
                    EXPECT_GE(mag(q - p), mag(nearest - p) - 1e-12);
                }
            }
        }
    }
}


TEST(SurfaceSet, FacesWithoutExtentHaveANearestPoint)
{
    surfaceSet surfaces(3);
    surfaces.append
    (
        pointField({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
        List<surfaceFace>(1, {0, 1, 2})
    );
    FixedList<scalar, 3> w;
    const point nearest(surfaces.nearestOnFace(0, point(1.5, 1, 0), w));
    EXPECT_NEAR(mag(nearest - point(1.5, 0, 0)), 0, 1e-12);

    surfaceSet segments(2);
    segments.append
    (
        pointField({{1, 1, 0}, {1, 1, 0}}),
        List<surfaceFace>(1, {0, 1, -1})
    );
    EXPECT_EQ(segments.nearestOnFace(0, point(3, 3, 0), w), point(1, 1, 0));
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
