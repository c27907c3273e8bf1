// SPDX-License-Identifier: GPL-3.0-or-later
// Walls with openings: the distance from them, and bodies that pass them, or
// are held beside them, or meet their edges

#include <gtest/gtest.h>

#include "IStringStream.H"
#include "rigidSpheres.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar h = 0.2;

const vector down(0, -1, 0);

//- The wall y = 0 with the opening -width < x < width, in space also
//  -width < z < width. Rims have a point per h
contactWall wallWithOpening(const scalar width, const direction nDims = 2)
{
    const point least(-GREAT, -GREAT, -GREAT), most(GREAT, 0, GREAT);
    List<boundBox> parts(2*(nDims - 1), boundBox(least, most));
    parts[0].max().x() = -width;
    parts[1].min().x() = width;
    DynamicList<point> rim;
    if (nDims == 3)
    {
        parts[2].max().z() = -width;
        parts[3].min().z() = width;
        const label n = std::lround(2*width/h);
        for (label i = 0; i < n; ++i)
        {
            const scalar s = width*(2.0*i/n - 1);
            rim.append(point(s, 0, -width));
            rim.append(point(width, 0, s));
            rim.append(point(-s, 0, width));
            rim.append(point(-width, 0, -s));
        }
    }
    else
    {
        rim.append(point(-width, 0, 0));
        rim.append(point(width, 0, 0));
    }
    contactWall wall(point(0, 0, 0), vector(0, 1, 0));
    wall.setParts(parts, pointField(rim));
    return wall;
}


scalar gapOf(const contactWall& wall, const point& p)
{
    vector away;
    return wall.gap(p, away);
}


//- Distance of rims from the nearest body, negative if one is inside [m]
scalar rimGap(const rigidBodies& world, const scalar range)
{
    contactPairs found;
    contactGeometry geometry(false);
    geometry.update(world.surfaces);
    for (label i = 0; i < world.surfaces.size(); ++i)
    {
        geometry.appendRims
        (
            world.surfaces, i, world.walls, range, found.pairs
        );
    }
    scalar least = range;
    for (const contactPair& pair : found.pairs)
    {
        least = min(least, pair.gap);
    }
    return least;
}


//- Least gap of nodes from the first wall, and of rims from bodies, at most
//  the range [m]
scalar leastGap(const rigidBodies& world, const scalar range)
{
    scalar least = rimGap(world, range);
    for (const point& p : world.surfaces.points())
    {
        least = min(least, gapOf(world.walls[0], p));
    }
    return least;
}


contact contactOf(const std::string& text, const direction nDims = 2)
{
    return contact(dictionary(IStringStream(text)()), nDims, h, 1);
}

} // End anonymous namespace


TEST(ContactOpenings, gapIsTheDistanceFromTheWall)
{
    const contactWall wall(wallWithOpening(1));
    vector away;
    EXPECT_EQ(wall.gap(point(-3, 0.5, 0), away), 0.5);
    EXPECT_EQ(away, vector(0, 1, 0));
    EXPECT_NEAR(wall.gap(point(0.7, -5, 0), away), 0.3, 1e-15);
    EXPECT_EQ(away, vector(-1, 0, 0));
    EXPECT_NEAR(wall.gap(point(0.7, 0.4, 0), away), 0.5, 1e-15);
    EXPECT_NEAR(mag(away - vector(-0.6, 0.8, 0)), 0, 1e-15);
    EXPECT_EQ(wall.gap(point(-1.3, -0.1, 0), away), -0.1);
    EXPECT_EQ(away, vector(0, 1, 0));
    EXPECT_NEAR(wall.gap(point(-1.1, -2, 0), away), -0.1, 1e-15);
    EXPECT_EQ(away, vector(1, 0, 0));

    const contactWall inSpace(wallWithOpening(1, 3));
    EXPECT_NEAR(gapOf(inSpace, point(-1.5, 0.5, 7)), 0.5, 1e-15);
    EXPECT_NEAR(gapOf(inSpace, point(0.8, -3, 0.9)), 0.1, 1e-15);
    EXPECT_NEAR(gapOf(inSpace, point(0.8, 0.4, -0.7)), std::sqrt(0.2), 1e-15);
}


TEST(ContactOpenings, anEdgeBetweenTwoNodesPushesThem)
{
    // A square, turned so that its lower face meets the edge and its corners
    // are far from the wall
    rigidBodies world;
    const pointField corners({{1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}});
    world.add(corners, {1, 1.7, 0}, down);
    world.solids[0].turn = rotationBy(vector(0, 0, 0.3));
    world.walls = List<contactWall>(1, wallWithOpening(1));
    contact law(contactOf(""));
    scalar least = GREAT, energy = 0, kinetic = 0.5;
    for (label i = 0; i < 400; ++i)
    {
        world.advance(law, 0.01);
        energy = max(energy, kinetic + world.statistics.potentialEnergy);
        kinetic = world.kineticEnergy();
        world.update();
        least = min(least, leastGap(world, 1));
    }
    EXPECT_GT(least, 0.09*h);
    EXPECT_LT(energy, 0.5*1.001);
    EXPECT_GT(mag(world.solids[0].spin), 0.1);
}


TEST(ContactOpenings, discsPassOrAreHeld)
{
    // Offset of the disc of radius 1 from the middle of the opening
    for (const scalar offset : {0.0, 0.3, 1.2, 1.9, 2.5, 6.0})
    {
        for (const char* law : {"law { stiffness 0.02; restitution 0.3; }",
            "law { stiffness 0.05; restitution 0.3; }"})
        {
            rigidBodies world;
            world.add(circleNodes(1, 40), {offset, 1.5, 0}, 0.3*down);
            world.walls = List<contactWall>(1, wallWithOpening(1.5));
            contact touch(contactOf(law));
            scalar least = GREAT;
            for (label i = 0; i < 1000; ++i)
            {
                world.solids[0].velocity += 0.002*down;
                world.advance(touch, 0.02);
                world.update();
                least = min(least, leastGap(world, 1));
            }
            EXPECT_GT(least, 0) << "offset " << offset << ' ' << law;
            const scalar y = world.solids[0].centre.y();
            if (offset > 1.5)
            {
                EXPECT_GT(y, 0.9) << offset;
            }
            else
            {
                EXPECT_LT(y, -5) << offset;
            }
            if (offset == 0)
            {
                EXPECT_NEAR(world.solids[0].velocity.y(), -2.3, 0.05);
            }
        }
    }
}


TEST(ContactOpenings, spheresPassOrAreHeld)
{
    for (const vector& offset : {vector(0, 0, 0.3), vector(1.2, 0, 1.1),
        vector(0.2, 0, 1.7), vector(3.5, 0, 0)})
    {
        rigidBodies world(3);
        add
        (
            world, sphereAtOrigin(1, 2), offset + vector(0, 1.5, 0), 0.3*down
        );
        world.walls = List<contactWall>(1, wallWithOpening(1.4, 3));
        contact touch(contactOf("law { stiffness 0.02; restitution 0.3; }", 3));
        scalar least = GREAT;
        for (label i = 0; i < 600; ++i)
        {
            world.solids[0].velocity += 0.004*down;
            world.advance(touch, 0.04);
            world.update();
            least = min(least, leastGap(world, 1));
        }
        EXPECT_GT(least, 0) << offset.x();
        const scalar y = world.solids[0].centre.y();
        if (max(offset.x(), offset.z()) > 1.4)
        {
            EXPECT_GT(y, 0.9) << offset.x();
        }
        else
        {
            EXPECT_LT(y, -5) << offset.x();
        }
    }
}
