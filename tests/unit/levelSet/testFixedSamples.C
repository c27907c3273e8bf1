// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "periodicImages.H"
#include "sampleRanges.H"
#include "surfaceDistance.H"
#include "samples/surfaceSamples.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Append a disc or a sphere
static void appendBall
(
    surfaceSet& surfaces,
    const point& centre,
    const scalar radius
)
{
    if (surfaces.nDims() == 2)
    {
        appendDisc(surfaces, point(centre.x(), centre.y(), 0), radius, 60);
    }
    else
    {
        appendSphere(surfaces, centre, radius, 2);
    }
}


//- A large ball and two small ones, which move with a parameter
static surfaceSet threeBalls
(
    const direction nDims,
    const scalar t,
    const bool fixed
)
{
    surfaceSet surfaces(nDims);
    appendBall(surfaces, point(0.5, 0.5, 0.5), 0.2);
    appendBall(surfaces, point(0.1 + t, 0.52, 0.45), 0.06);
    appendBall(surfaces, point(0.5, 0.95 - 0.3*t, 0.5), 0.08);
    if (fixed)
    {
        surfaces.setFixed(0);
    }
    return surfaces;
}


static void expectSame(const surfaceDistance& a, const surfaceDistance& b)
{
    ASSERT_EQ(a.distance().size(), b.distance().size());
    forAll(a.distance(), i)
    {
        ASSERT_EQ(a.distance()[i], b.distance()[i]) << "sample " << i;
        ASSERT_EQ(a.nearestFace()[i], b.nearestFace()[i]) << "sample " << i;
        ASSERT_EQ(a.object()[i], b.object()[i]) << "sample " << i;
    }
}


// One ball passes the fixed one and leaves the block, boxes overlap
TEST(FixedSamples, KeptDistancesAreThoseMadeAnew)
{
    for (const direction nDims : {2, 3})
    {
        // Small against the block, and not so
        for (const label n : {20, nDims == 2 ? 300 : 60})
        {
            const cartesianBlock block(cellCentres(vector::zero, 1, n, nDims));
            surfaceDistance kept(3*block.spacing());
            for (const scalar t : {0.0, 0.05, 0.2, 0.4, 0.7, 1.3, 0.1})
            {
                kept.update(threeBalls(nDims, t, true), block);
                surfaceDistance anew(3*block.spacing());
                anew.update(threeBalls(nDims, t, false), block);
                expectSame(kept, anew);
            }
        }
    }
}


TEST(FixedSamples, NewPlacesLabelsAndBlocksAreNoticed)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 40, 2));
    surfaceDistance kept(3*block.spacing());
    const auto check = [&](const surfaceSet& s, const cartesianBlock& b)
    {
        kept.update(s, b);
        surfaceDistance anew(3*block.spacing());
        anew.update(s, b);
        expectSame(kept, anew);
    };

    surfaceSet surfaces(threeBalls(2, 0, true));
    check(surfaces, block);

    // One before it: its faces have other labels; then it is gone
    surfaceSet more(2);
    appendBall(more, point(0.2, 0.2, 0), 0.1);
    appendBall(more, point(0.5, 0.5, 0), 0.2);
    more.setFixed(1);
    check(more, block);
    for (label i = more.pointStart()[1]; i < more.pointStart()[2]; ++i)
    {
        more.points()[i].x() += 0.07;
    }
    check(more, block);
    surfaceSet fewer(2);
    appendBall(fewer, point(0.2, 0.2, 0), 0.1);
    check(fewer, block);
    check(fewer, cellCentres(vector::zero, 1, 30, 2));
    check(fewer, cellCentres(vector(0.01, 0, 0), 1, 30, 2));
}


TEST(FixedSamples, RangesHoldEachSampleOfTheBoxesOnce)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 40, 3));
    const boundBox boxes[] =
    {
        boundBox(point(0.1, 0.1, 0.1), point(0.3, 0.25, 0.3)),
        boundBox(point(0.2, 0.2, 0.2), point(0.5, 0.3, 0.4)),
        boundBox(point(0.8, -1, 0.5), point(2, 0.3, 0.7)),
        boundBox(point(2, 2, 2), point(3, 3, 3))
    };
    sampleRanges ranges;
    for (const boundBox& box : boxes)
    {
        ranges.add(block, box.min(), box.max());
    }
    ranges.merge(block);

    labelList n(block.size(), Zero);
    for (const labelPair& r : ranges.ranges())
    {
        for (label i = r.first(); i < r.second(); ++i)
        {
            ++n[i];
        }
    }
    label sum = 0;
    forAll(n, i)
    {
        bool inside = false;
        for (const boundBox& box : boxes)
        {
            inside = inside || box.contains(block.position(i));
        }
        ASSERT_EQ(n[i], inside ? 1 : 0) << "sample " << i;
        sum += n[i];
    }
    EXPECT_GT(sum, 1000);
    EXPECT_EQ(ranges.nSamples(), sum);

    ranges.add(block, point::zero, point::one);
    ranges.merge(block);
    ASSERT_EQ(ranges.ranges().size(), 1);
    EXPECT_EQ(ranges.ranges()[0], labelPair(0, block.size()));
}


//- The unit square, cyclic in x, with a wall below y = 0.2 from left to right
static surfaceSet wallBelow(const scalar left, const scalar right)
{
    surfaceSet surfaces(2);
    appendPolygon
    (
        surfaces,
        pointField
        ({
            {left, -0.5, 0}, {right, -0.5, 0}, {right, 0.2, 0}, {left, 0.2, 0}
        })
    );
    return surfaces;
}


TEST(FixedSamples, AFixedWallGoesThroughACyclicDomain)
{
    const boundBox square(point::zero, point(1, 1, 0));
    const scalar distance = 0.15;
    periodicImages images(square, vector(1, 0, 0));

    // A free one may not, a fixed one must reach out on both sides
    surfaceSet surfaces(wallBelow(-0.4, 1.4));
    EXPECT_THROW(images.update(surfaces, distance), Foam::error);
    surfaceSet ends(wallBelow(-0.1, 1.4));
    ends.setFixed(0);
    EXPECT_THROW(images.update(ends, distance), Foam::error);

    surfaces.setFixed(0);
    appendDisc(surfaces, point(0.98, 0.5, 0), 0.1, 24);
    const surfaceSet& all = images.update(surfaces, distance);
    ASSERT_EQ(all.size(), 3);
    EXPECT_EQ(all.original(2), 1);
    EXPECT_TRUE(all.fixed(0));
    EXPECT_FALSE(all.fixed(2));

    // The wall is the same in every column, those of the halo too
    const cartesianBlock block(cellCentres(point::zero, 1, 20, 2, 1));
    surfaceDistance levelSet(3*block.spacing());
    levelSet.update(all, block);
    for (label i = 0; i < block.n().x(); ++i)
    {
        for (label j = 0; j < 7; ++j)
        {
            const label samplei = block.index(i, j, 0);
            ASSERT_NEAR
            (
                levelSet.distance()[samplei],
                max(block.position(samplei).y() - 0.2, -3*block.spacing()),
                1e-14
            );
            ASSERT_EQ(levelSet.object()[samplei], 0);
        }
    }
}


// Fixed objects' images have the same labels, whatever images others have
TEST(FixedSamples, ImagesOfFixedObjectsComeFirst)
{
    periodicImages images
    (
        boundBox(point::zero, point(1, 1, 0)), vector(1, 1, 0)
    );
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0.02, 0.5, 0), 0.1, 24);
    appendDisc(surfaces, point(0.5, 0.02, 0), 0.1, 24);
    surfaces.setFixed(1);
    const surfaceSet& all = images.update(surfaces, 0.05);
    ASSERT_EQ(all.size(), 4);
    EXPECT_EQ(all.original(2), 1);
    EXPECT_EQ(all.original(3), 0);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
