// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "surfaceDistance.H"
#include "openArea.H"
#include "testSurfaces.H"

#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Times a polygon winds around p, from the angles its segments span
static label windingNumber
(
    const surfaceSet& surfaces,
    const label objecti,
    const point& p
)
{
    scalar angle = 0;
    const labelList& start = surfaces.faceStart();
    for (label i = start[objecti]; i < start[objecti + 1]; ++i)
    {
        const vector a(surfaces.points()[surfaces.faces()[i][0]] - p);
        const vector b(surfaces.points()[surfaces.faces()[i][1]] - p);
        angle += std::atan2((a ^ b).z(), a & b);
    }
    return std::lround(angle/constant::mathematical::twoPi);
}


//- Smallest distance to any face
static scalar bruteDistance(const surfaceSet& surfaces, const point& p)
{
    scalar smallest = GREAT;
    FixedList<scalar, 3> w;
    forAll(surfaces.faces(), facei)
    {
        smallest = min(smallest, mag(surfaces.nearestOnFace(facei, p, w) - p));
    }
    return smallest;
}


//- Star, biconcave outline, thin sliver and coarse triangle; their nodes lie
//  on rows of samples of an 80 x 80 lattice of [0, 1]^2 where asked
static surfaceSet awkwardPolygons()
{
    surfaceSet surfaces(2);
    appendStar(surfaces, point(0.25, 0.25, 0), 0.05, 0.2, 5);
    appendPolygon
    (
        surfaces,
        polarNodes
        (
            point(0.7, 0.25, 0),
            60,
            [](const scalar a) { return 0.12 + 0.08*Foam::cos(2*a); }
        )
    );
    // A sliver 0.3 spacings thick, slanting
    appendPolygon
    (
        surfaces,
        pointField
        ({
            {0.1, 0.6, 0}, {0.4, 0.8, 0}, {0.398, 0.803, 0}, {0.098, 0.603, 0}
        })
    );
    // Nodes and a whole side on rows of samples: y = (j + 1/2)/80
    const scalar low = 48.5/80, high = 70.5/80;
    appendPolygon
    (
        surfaces,
        pointField({{0.55, low, 0}, {0.95, low, 0}, {0.75, high, 0}})
    );
    return surfaces;
}


TEST(SurfaceDistance, DistanceAndFaceAreThoseOfASearchOverAllFaces)
{
    const surfaceSet surfaces(awkwardPolygons());
    const cartesianBlock block(cellCentres(vector::zero, 1, 80, 2));
    const scalar band = 4*block.spacing();
    surfaceDistance levelSet(band);
    levelSet.update(surfaces, block);

    label nBand = 0;
    FixedList<scalar, 3> w;
    forAll(levelSet.distance(), samplei)
    {
        const point p(block.position(samplei));
        const scalar exact = min(bruteDistance(surfaces, p), band);
        const label facei = levelSet.nearestFace()[samplei];
        ASSERT_NEAR(mag(levelSet.distance()[samplei]), exact, 1e-15);
        ASSERT_EQ(facei >= 0, exact < band);
        if (facei >= 0)
        {
            ++nBand;
            const point nearest(surfaces.nearestOnFace(facei, p, w));
            ASSERT_NEAR(mag(nearest - p), exact, 1e-15);
            ASSERT_EQ
            (
                levelSet.object()[samplei], surfaces.faceObject()[facei]
            );
        }
    }
    EXPECT_GT(nBand, 2000);
    EXPECT_LT(nBand, block.size());
}


TEST(SurfaceDistance, SignIsThatOfTheWindingNumberOnAwkwardPolygons)
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
                if (windingNumber(surfaces, objecti, p) != 0)
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


TEST(SurfaceDistance, ObjectsReachingOutOfTheBlockKeepTheirSign)
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
            windingNumber(surfaces, 0, p) || windingNumber(surfaces, 1, p);
        ASSERT_EQ(levelSet.distance()[samplei] < 0, inside);
        ASSERT_LT(levelSet.object()[samplei], 2);
    }
}


TEST(SurfaceDistance, ResultsDoNotDependOnTheBlockBitwise)
{
    for (const direction nDims : {2, 3})
    {
        surfaceSet surfaces(nDims);
        if (nDims == 2)
        {
            surfaces = awkwardPolygons();
        }
        else
        {
            appendSphere(surfaces, point(0.4, 0.45, 0.5), 0.22, 3);
            appendSphere(surfaces, point(0.8, 0.45, 0.5), 0.12, 2);
        }
        const label n = nDims == 2 ? 101 : 37;
        const cartesianBlock whole(cellCentres(vector::zero, 1, n, nDims));
        surfaceDistance all(4*whole.spacing()), some(4*whole.spacing());
        all.update(surfaces, whole);

        label nCompared = 0;
        for (label corner = 0; corner < 8; ++corner)
        {
            labelVector start, size;
            for (direction dir = 0; dir < 3; ++dir)
            {
                const label cut = n/3 + 2*dir;
                const bool upper = corner & (1 << dir);
                start[dir] = upper ? cut : 0;
                size[dir] = upper ? n - cut : cut;
            }
            if (nDims == 2)
            {
                if (corner > 3)
                {
                    continue;
                }
                start.z() = 0;
                size.z() = 1;
            }
            const cartesianBlock part
            (
                whole.origin(), whole.spacing(), size, nDims, start
            );
            some.update(surfaces, part);
            forAll(some.distance(), samplei)
            {
                const label there = whole.index(part.ijk(samplei) + start);
                ASSERT_EQ(some.distance()[samplei], all.distance()[there]);
                ASSERT_EQ
                (
                    some.nearestFace()[samplei], all.nearestFace()[there]
                );
                ASSERT_EQ(some.object()[samplei], all.object()[there]);
                ++nCompared;
            }
        }
        EXPECT_EQ(nCompared, whole.size());
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


TEST(SurfaceDistance, SphereIsExactAndSigned)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    checkSphere(block, point(0.51, 0.48, 0.5));
}


// Nodes and edges of the surface on planes and rows of samples
TEST(SurfaceDistance, SphereOnASampleIsExactAndSigned)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    checkSphere(block, block.position(labelVector(12, 11, 12)));
}


// A solid box whose faces, edges and corners all lie on samples
TEST(SurfaceDistance, BoxOnTheLatticeIsNotLeaky)
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


// The zero of the corners' distances, taken as linear between them, cuts off
// two twelfths of (h/R)^2 of a disc
TEST(SurfaceDistance, EnclosedAreaIsOfSecondOrder)
{
    scalar coarse = 0;
    for (const label cellsPerRadius : {8, 16, 32})
    {
        scalar error = 0;
        for (label shift = 0; shift < 8; ++shift)
        {
            surfaceSet surfaces(2);
            appendDisc
            (
                surfaces, point(0.5 + 0.0031*shift, 0.5, 0), 0.25, 400
            );
            const cartesianBlock block
            (
                cellCentres(vector::zero, 1, 4*cellsPerRadius, 2)
            );
            surfaceDistance levelSet(3*block.spacing());
            levelSet.update(surfaces, block);

            scalar area = 0;
            const scalarField& phi = levelSet.distance();
            for (label j = 0; j + 1 < block.n().y(); ++j)
            {
                for (label i = 0; i + 1 < block.n().x(); ++i)
                {
                    area += 1 - openSquare
                    ({
                        phi[block.index(i, j, 0)],
                        phi[block.index(i + 1, j, 0)],
                        phi[block.index(i + 1, j + 1, 0)],
                        phi[block.index(i, j + 1, 0)]
                    });
                }
            }
            area *= sqr(block.spacing());
            error = max(error, mag(area/surfaces.volume(0) - 1));
        }
        EXPECT_LT(error, 1.1/6*sqr(1.0/cellsPerRadius));
        if (coarse > 0)
        {
            EXPECT_GT(coarse/error, 3.2);
        }
        coarse = error;
    }
}


// At a node both faces are at the same distance, here to the last bit
TEST(SurfaceDistance, FirstOfTwoFacesAtTheSameDistanceCounts)
{
    surfaceSet surfaces(2);
    appendPolygon
    (
        surfaces,
        pointField({{4, 4, 0}, {8, 4, 0}, {8, 8, 0}, {4, 8, 0}})
    );
    const cartesianBlock block(point::zero, 1, labelVector(13, 13, 1), 2);
    surfaceDistance levelSet(3);
    levelSet.update(surfaces, block);
    EXPECT_EQ(levelSet.nearestFace()[block.index(3, 3, 0)], 0);
    EXPECT_EQ(levelSet.nearestFace()[block.index(9, 3, 0)], 0);
    EXPECT_EQ(levelSet.nearestFace()[block.index(9, 9, 0)], 1);
    EXPECT_EQ(levelSet.nearestFace()[block.index(3, 9, 0)], 2);
    EXPECT_EQ(levelSet.nearestFace()[block.index(5, 5, 0)], 0);
}


TEST(SurfaceDistance, VelocityIsThatOfTheNearestSurfacePoint)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0.5, 0.5, 0), 0.25, 2000);
    const vector spin(0, 0, 3);
    forAll(surfaces.points(), i)
    {
        surfaces.velocities()[i] =
            spin ^ (surfaces.points()[i] - point(0.5, 0.5, 0));
    }
    const cartesianBlock block(cellCentres(vector::zero, 1, 40, 2));
    surfaceDistance levelSet(3*block.spacing());
    levelSet.update(surfaces, block);

    // The polygon's corners turn the normal by up to 1.6e-3
    vectorField velocity;
    levelSet.extendVelocity(surfaces, block, velocity);

    label nBand = 0;
    forAll(velocity, samplei)
    {
        if (levelSet.nearestFace()[samplei] < 0)
        {
            EXPECT_EQ(velocity[samplei], vector::zero);
            continue;
        }
        const vector r(block.position(samplei) - point(0.5, 0.5, 0));
        EXPECT_NEAR(mag(velocity[samplei] - 0.25*(spin ^ r)/mag(r)), 0, 4e-4);
        ++nBand;
    }
    EXPECT_GT(nBand, 100);
}


TEST(SurfaceDistance, RefusesBadInput)
{
    EXPECT_THROW(surfaceDistance(0), Foam::error);
    EXPECT_THROW(surfaceDistance(-1), Foam::error);
    EXPECT_THROW
    (
        surfaceDistance(std::numeric_limits<scalar>::quiet_NaN()), Foam::error
    );

    const cartesianBlock block(cellCentres(vector::zero, 1, 20, 2));
    surfaceDistance levelSet(0.1);

    surfaceSet open(2);
    open.append
    (
        pointField({{0.2, 0.2, 0}, {0.8, 0.8, 0}}),
        List<surfaceFace>(1, {0, 1, -1})
    );
    EXPECT_THROW(levelSet.update(open, block), Foam::error);

    surfaceSet lost(2);
    appendDisc(lost, point(0.5, 0.5, 0), 0.2, 20);
    lost.points()[7].x() = std::numeric_limits<scalar>::quiet_NaN();
    EXPECT_THROW(levelSet.update(lost, block), Foam::error);

    surfaceSet solid(3);
    appendSphere(solid, point(0.5, 0.5, 0), 0.2, 1);
    EXPECT_THROW(levelSet.update(solid, block), Foam::error);

    // No surface is no error: all is fluid
    levelSet.update(surfaceSet(2), block);
    EXPECT_EQ(min(levelSet.distance()), 0.1);
    EXPECT_EQ(max(levelSet.object()), -1);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
