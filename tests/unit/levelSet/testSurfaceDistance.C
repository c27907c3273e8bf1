// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "surfaceDistance.H"
#include "samples/surfaceSamples.H"

#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

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
        // A face at the band's edge to round-off is not noticed
        ASSERT_EQ(facei >= 0, exact < (1 - 1e-10)*band);
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


// An object leaves nothing behind: it is as if it had never been there
TEST(SurfaceDistance, MovingObjectsLeaveNothingBehind)
{
    for (const direction nDims : {2, 3})
    {
        const label n = nDims == 2 ? 96 : 32;
        const cartesianBlock block(cellCentres(vector::zero, 1, n, nDims));
        const scalar band = 3*block.spacing();
        surfaceDistance moved(band);
        for (label stepi = 0; stepi < 30; ++stepi)
        {
            const point centre(0.3 + 0.0131*stepi, 0.4 + 0.0037*stepi, 0.5);
            surfaceSet surfaces(nDims);
            if (nDims == 2)
            {
                appendDisc(surfaces, centre, 0.1, 25);
            }
            else
            {
                appendSphere(surfaces, centre, 0.15, 2);
            }
            moved.update(surfaces, block);
            surfaceDistance fresh(band);
            fresh.update(surfaces, block);
            ASSERT_EQ(moved.distance(), fresh.distance()) << stepi;
            ASSERT_EQ(moved.nearestFace(), fresh.nearestFace()) << stepi;
            ASSERT_EQ(moved.object(), fresh.object()) << stepi;
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

            const scalar area = enclosedArea(block, levelSet.distance());
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
