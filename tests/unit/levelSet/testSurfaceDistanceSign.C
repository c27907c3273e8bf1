// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "surfaceDistance.H"
#include "samples/surfaceSamples.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

TEST(SurfaceDistanceSign, SignIsThatOfTheWindingNumberOnAwkwardPolygons)
{
    const surfaceSet surfaces(awkwardPolygons());
    // Shifted and unshifted lattices, coarse and fine
    for (const label n : {11, 80, 233})
    {
        const cartesianBlock block(cellCentres(vector::zero, 1, n, 2));
        surfaceDistance levelSet(2*block.spacing());
        levelSet.update(surfaces, block);

        label nInside = 0;
        forAll(levelSet.distance(), samplei)
        {
            const point p(block.position(samplei));
            if (mag(levelSet.distance()[samplei]) < 1e-12)
            {
                continue;
            }
            label containing = -1;
            for (label objecti = 0; objecti < surfaces.size(); ++objecti)
            {
                if (turnsAround(surfaces, objecti, p) != 0)
                {
                    containing = objecti;
                }
            }
            ASSERT_EQ(levelSet.distance()[samplei] < 0, containing >= 0)
                << "sample " << samplei;
            if (containing >= 0)
            {
                ASSERT_EQ(levelSet.object()[samplei], containing)
                << "sample " << samplei;
                ++nInside;
            }
            else if (levelSet.nearestFace()[samplei] < 0)
            {
                ASSERT_EQ(levelSet.object()[samplei], -1);
            }
        }
        EXPECT_GT(nInside, n > 11 ? 700 : 10);
    }
}


TEST(SurfaceDistanceSign, ObjectsReachingOutOfTheBlockKeepTheirSign)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0, 0.5, 0), 0.3, 50);
    appendDisc(surfaces, point(1.05, 1.05, 0), 0.3, 50);
    appendDisc(surfaces, point(7, 0.5, 0), 0.3, 50);
    appendDisc(surfaces, point(-7, 0.5, 0), 0.3, 50);
    const cartesianBlock block(cellCentres(vector::zero, 1, 40, 2));
    surfaceDistance levelSet(3*block.spacing());
    levelSet.update(surfaces, block);

    forAll(levelSet.distance(), samplei)
    {
        const point p(block.position(samplei));
        const bool inside =
            turnsAround(surfaces, 0, p) || turnsAround(surfaces, 1, p);
        ASSERT_EQ(levelSet.distance()[samplei] < 0, inside);
        ASSERT_LT(levelSet.object()[samplei], 2);
    }
}


//- Compare a sphere's level set with a search, and its sign with the radius
static void checkSphere(const cartesianBlock& block, const point& centre)
{
    const scalar radius = 7*block.spacing();
    surfaceSet surfaces(3);
    appendSphere(surfaces, centre, radius, 3);
    surfaceDistance levelSet(3*block.spacing());
    levelSet.update(surfaces, block);

    // The triangles lie between this radius and the sphere's
    scalar inner = GREAT;
    FixedList<scalar, 3> w;
    forAll(surfaces.faces(), facei)
    {
        const point p(surfaces.nearestOnFace(facei, centre, w));
        inner = min(inner, mag(p - centre));
    }
    EXPECT_GT(inner, 0.95*radius);

    forAll(levelSet.distance(), samplei)
    {
        const point p(block.position(samplei));
        const scalar r = mag(p - centre);
        if (r < inner - SMALL)
        {
            ASSERT_LT(levelSet.distance()[samplei], 0);
            ASSERT_EQ(levelSet.object()[samplei], 0);
        }
        if (r > radius + SMALL)
        {
            ASSERT_GT(levelSet.distance()[samplei], 0);
        }
        if (samplei % 3 == 0)
        {
            const scalar exact =
                min(bruteDistance(surfaces, p), levelSet.bandWidth());
            ASSERT_NEAR(mag(levelSet.distance()[samplei]), exact, 1e-14);
        }
    }
}


TEST(SurfaceDistanceSign, SphereIsExactAndSigned)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    checkSphere(block, point(0.51, 0.48, 0.5));
}


// Nodes and edges of the surface on planes and rows of samples
TEST(SurfaceDistanceSign, SphereOnASampleIsExactAndSigned)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    checkSphere(block, block.position(labelVector(12, 11, 12)));
}


// A solid box whose faces, edges and corners all lie on samples
TEST(SurfaceDistanceSign, BoxOnTheLatticeIsNotLeaky)
{
    surfaceSet surfaces(3);
    pointField nodes(8);
    forAll(nodes, i)
    {
        nodes[i] = point(i & 1 ? 6 : 2, i & 2 ? 7 : 3, i & 4 ? 8 : 4);
    }
    surfaces.append
    (
        nodes,
        List<surfaceFace>
        ({
            {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
            {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
            {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}
        })
    );
    EXPECT_NEAR(surfaces.volume(0), 64, 1e-12);

    const cartesianBlock block(point::zero, 1, labelVector(10, 10, 12), 3);
    surfaceDistance levelSet(1.5);
    levelSet.update(surfaces, block);
    forAll(levelSet.distance(), samplei)
    {
        const point p(block.position(samplei));
        const point q(p - point(4, 5, 6));
        const scalar outside =
            max(max(mag(q.x()), mag(q.y())), mag(q.z())) - 2;
        if (outside > 0)
        {
            ASSERT_GT(levelSet.distance()[samplei], 0)
                << "sample " << samplei;
        }
        else if (outside < 0)
        {
            ASSERT_LT(levelSet.distance()[samplei], 0)
                << "sample " << samplei;
        }
    }
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
