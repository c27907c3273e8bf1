// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "membraneGapLimit.H"
#include "surfaceWinding.H"
#include "samples/surfaceSamples.H"

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A coarse and a fine sphere of the radius 1, membranes with two distances of
//  their centres
surfaceSet spheres(const vector& apart)
{
    surfaceSet surfaces(3);
    appendSphere(surfaces, point(0, 0, 0), 1, 2);
    appendSphere(surfaces, apart, 1, 3);
    surfaces.setImmersed(0, true);
    surfaces.setImmersed(1, true);
    return surfaces;
}


//- The distance of a node from the faces of the other object
scalar distance(const surfaceSet& surfaces, const label nodei)
{
    const label other = 1 - surfaces.pointObject()[nodei];
    scalar least = GREAT;
    FixedList<scalar, 3> weights;
    const point& x = surfaces.points()[nodei];
    const label end = surfaces.faceStart()[other + 1];
    for (label i = surfaces.faceStart()[other]; i < end; ++i)
    {
        least = min(least, mag(surfaces.nearestOnFace(i, x, weights) - x));
    }
    return least;
}


//- Number of pairs; each of them is what a look at all faces finds
label checked
(
    const membraneGaps& gaps,
    const surfaceSet& surfaces,
    const scalar range
)
{
    labelList ofNode(surfaces.points().size(), 0);
    label nInside = 0;
    for (const membraneGaps::pair& p : gaps.pairs())
    {
        ++ofNode[p.node];
        const label own = surfaces.pointObject()[p.node];
        EXPECT_EQ(surfaces.faceObject()[p.face], 1 - own);
        EXPECT_NEAR(mag(p.gap), distance(surfaces, p.node), 1e-12);
        const point place
        (
            surfaces.interpolate(surfaces.points(), p.face, p.weights)
        );
        const vector error
        (
            place + p.gap*p.normal - surfaces.points()[p.node]
        );
        EXPECT_NEAR(mag(error), 0, 1e-12);
        const point centre(surfaces.centroid(1 - own));
        const bool inside =
            contains(surfaces, 1 - own, surfaces.points()[p.node]);
        nInside += inside;
        EXPECT_EQ(p.gap < 0, inside);
        EXPECT_GT(p.normal & (place - centre), 0);
    }
    forAll(ofNode, nodei)
    {
        EXPECT_EQ(ofNode[nodei], distance(surfaces, nodei) < range);
    }
    return nInside;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(membraneGaps, areThoseOfALookAtAllFaces)
{
    membraneGaps gaps(vector::zero, 0.2);
    const vector along(0.6, 0.64, -0.48);
    for (const scalar apart : {2.05, 1.8})
    {
        const surfaceSet surfaces(spheres(apart*along));
        gaps.find(surfaces, 2, 0.25);
        EXPECT_GT(gaps.pairs().size(), 10);
        EXPECT_EQ(checked(gaps, surfaces, 0.25) > 0, apart < 2);
    }
}


TEST(membraneGaps, crossCyclicSides)
{
    const vector period(5, 0, 4), apart(1.23, 1.31, -0.98);
    membraneGaps gaps(period, 0.2);
    const surfaceSet here(spheres(apart));
    gaps.find(here, 2, 0.25);
    const List<membraneGaps::pair> pairs(gaps.pairs());
    const surfaceSet there(spheres(apart + vector(-5, 0, 8)));
    gaps.find(there, 2, 0.25);
    ASSERT_EQ(gaps.pairs().size(), pairs.size());
    ASSERT_GT(pairs.size(), 10);
    forAll(pairs, i)
    {
        EXPECT_EQ(gaps.pairs()[i].node, pairs[i].node);
        EXPECT_NEAR(gaps.pairs()[i].gap, pairs[i].gap, 1e-12);
    }
}


TEST(membraneGaps, areForOwnedObjectsAndMembranes)
{
    membraneGaps gaps(vector::zero, 0.2);
    surfaceSet surfaces(spheres(vector(1.2, 1.3, -0.9)));
    gaps.find(surfaces, 1, 0.25);
    EXPECT_GT(gaps.pairs().size(), 3);
    for (const membraneGaps::pair& p : gaps.pairs())
    {
        EXPECT_EQ(surfaces.pointObject()[p.node], 0);
    }
    surfaces.setImmersed(1, false);
    gaps.find(surfaces, 2, 0.25);
    EXPECT_GT(gaps.pairs().size(), 3);
    for (const membraneGaps::pair& p : gaps.pairs())
    {
        EXPECT_EQ(surfaces.pointObject()[p.node], 1);
    }
    surfaces.setImmersed(0, false);
    gaps.find(surfaces, 2, 0.25);
    EXPECT_EQ(gaps.pairs().size(), 0);
}


TEST(membraneGaps, facesGiveWayToBodies)
{
    // A fine sphere with walls comes 0.1 nearer to a coarse membrane in a step
    membraneGaps gaps(vector::zero, 0.2);
    const vector along(0.6, 0.64, -0.48);
    surfaceSet surfaces(spheres(2.05*along));
    surfaces.setImmersed(1, false);
    const scalar dt = 1e-3, least = 0.02;
    gaps.find(surfaces, 2, 0.25);
    vectorField v(surfaces.points().size(), Zero);
    const label start = surfaces.pointStart()[1];
    for (label i = start; i < v.size(); ++i)
    {
        v[i] = -100*along;
    }
    membraneGapLimit(surfaces, gaps.pairs(), dt, least, v).giveWay(v);
    for (label i = start; i < v.size(); ++i)
    {
        EXPECT_EQ(v[i], -100*along);
    }
    surfaces.points() += dt*v;
    gaps.find(surfaces, 2, 0.25);
    EXPECT_GT(gaps.pairs().size(), 10);
    for (const membraneGaps::pair& p : gaps.pairs())
    {
        EXPECT_GT(p.gap, 0.5*least);
    }
}


TEST(membraneGaps, changesKeepTheLeastGap)
{
    // The second sphere comes nearer by 0.1 in a step. Without the changes many
    // nodes of it would be inside the first one
    membraneGaps gaps(vector::zero, 0.2);
    const vector along(0.6, 0.64, -0.48);
    surfaceSet surfaces(spheres(2.05*along));
    const scalar dt = 1e-3, least = 0.02;
    gaps.find(surfaces, 2, 0.25);
    vectorField v(surfaces.points().size(), Zero);
    for (label i = surfaces.pointStart()[1]; i < v.size(); ++i)
    {
        v[i] = -100*along;
    }
    const membraneGapLimit limit(surfaces, gaps.pairs(), dt, least, v);
    for (label i = 0; i < 20; ++i)
    {
        vectorField changes(v.size(), Zero);
        limit.addChanges(v, changes);
        EXPECT_NEAR(mag(sum(changes)), 0, 1e-12*100);
        v += changes;
    }
    for (const membraneGaps::pair& p : gaps.pairs())
    {
        const vector apart
        (
            v[p.node] - surfaces.interpolate(v, p.face, p.weights)
        );
        EXPECT_GT(p.gap + dt*(apart & p.normal), least - 1e-3);
    }
    surfaces.points() += dt*v;
    gaps.find(surfaces, 2, 0.25);
    for (const membraneGaps::pair& p : gaps.pairs())
    {
        EXPECT_GT(p.gap, 0.5*least);
    }

    // Away from each other nothing changes
    v = -v;
    vectorField changes(v.size(), Zero);
    for (label i = 0; i < surfaces.pointStart()[1]; ++i)
    {
        v[i] = Zero;
    }
    for (label i = surfaces.pointStart()[1]; i < v.size(); ++i)
    {
        v[i] = 100*along;
    }
    limit.addChanges(v, changes);
    EXPECT_EQ(max(mag(changes)), 0);
}


// ************************************************************************* //
