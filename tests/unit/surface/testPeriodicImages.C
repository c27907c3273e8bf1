// SPDX-License-Identifier: GPL-3.0-or-later

#include "contact.H"
#include "periodicImages.H"
#include "SubField.H"
#include "surfaceDistance.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- The unit square, cyclic in x or in both directions
periodicImages unitSquare(const bool both)
{
    return periodicImages
    (
        boundBox(point(0, 0, 0), point(1, 1, 0)),
        vector(1, both ? 1 : 0, 0)
    );
}


//- Append a polygon of 24 nodes with the outline of a disc
void appendDisc(surfaceSet& surfaces, const point& centre, const scalar radius)
{
    const label n = 24;
    pointField points(n);
    List<surfaceFace> faces(n);
    for (label i = 0; i < n; ++i)
    {
        const scalar angle = 2*3.14159265358979*i/n;
        points[i] =
            centre
          + radius*vector(Foam::cos(angle), Foam::sin(angle), 0);
        faces[i] = surfaceFace({i, (i + 1) % n, -1});
    }
    surfaces.append(points, faces);
}


//- Number of images of one disc
label nImages(const point& centre, const bool both)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, centre, 0.1);
    periodicImages images(unitSquare(both));
    const surfaceSet& all = images.update(surfaces, 0.05);
    return all.size() - all.nOriginals();
}

} // End anonymous namespace


TEST(periodicImages, areThoseThatReachTheDomain)
{
    EXPECT_EQ(nImages(point(0.5, 0.5, 0), true), 0);
    EXPECT_EQ(nImages(point(0.12, 0.5, 0), true), 1);
    EXPECT_EQ(nImages(point(0.95, 0.5, 0), true), 1);
    EXPECT_EQ(nImages(point(0.05, 0.98, 0), true), 3);

    // The other direction is not cyclic
    EXPECT_EQ(nImages(point(0.5, 0.98, 0), false), 0);
    EXPECT_EQ(nImages(point(0.05, 0.98, 0), false), 1);
}


TEST(periodicImages, areNotNeededBesideTheEndsOfAWall)
{
    // A wall through the domain does not call images of what is in the middle
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0.5, 3, 0), 2.4);
    surfaces.setFixed(0, true);
    appendDisc(surfaces, point(0.5, 0.3, 0), 0.1);
    periodicImages images(unitSquare(false));
    EXPECT_EQ(images.update(surfaces, 0.05).size(), 2);
}


TEST(periodicImages, belongToTheirOriginals)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0.5, 0.5, 0), 0.1);
    appendDisc(surfaces, point(0.98, 0.5, 0), 0.1);
    surfaces.velocities()[30] = vector(3, 4, 0);
    periodicImages images(unitSquare(false));
    const surfaceSet& all = images.update(surfaces, 0.05);

    ASSERT_EQ(all.size(), 3);
    EXPECT_EQ(all.nOriginals(), 2);
    EXPECT_EQ(all.original(0), 0);
    EXPECT_EQ(all.original(1), 1);
    EXPECT_EQ(all.original(2), 1);
    const label nodei = all.pointStart()[2] + 6;
    EXPECT_EQ(all.originalNode(nodei), 30);
    EXPECT_EQ(all.originalNode(7), 7);
    EXPECT_EQ(all.velocities()[nodei], vector(3, 4, 0));
    EXPECT_NEAR(all.points()[nodei].x(), surfaces.points()[30].x() - 1, 1e-15);
    for (label facei = all.faceStart()[2]; facei < all.faceStart()[3]; ++facei)
    {
        const label original = all.originalFace(facei);
        EXPECT_EQ(all.faceObject()[facei], 2);
        EXPECT_EQ(all.faceObject()[original], 1);
        for (label i = 0; i < 2; ++i)
        {
            EXPECT_EQ
            (
                all.originalNode(all.faces()[facei][i]),
                all.faces()[original][i]
            );
        }
    }
    EXPECT_NEAR(all.volume(2), all.volume(1), 1e-15);
}


TEST(periodicImages, leaveOpenDomainsAlone)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0, 0.5, 0), 0.1);
    periodicImages none;
    EXPECT_FALSE(none.cyclic());
    EXPECT_EQ(&none.update(surfaces, 0.05), &surfaces);
}


TEST(periodicImages, refusesAPeriodTooShortForAnObject)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0.5, 0.5, 0), 0.48);
    periodicImages images(unitSquare(false));
    EXPECT_NO_THROW(images.update(surfaces, 0.03));
    EXPECT_THROW(images.update(surfaces, 0.05), Foam::error);
}


TEST(periodicImages, countPeriodsOutside)
{
    const periodicImages images(unitSquare(true));
    EXPECT_EQ
    (
        images.periodsOutside(point(0.2, 0.9, 0)), labelVector(0, 0, 0)
    );
    EXPECT_EQ
    (
        images.periodsOutside(point(-0.1, 2.5, 7)), labelVector(-1, 2, 0)
    );
}


TEST(periodicImages, makeTheLevelSetPeriodic)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, point(0.97, 0.03, 0), 0.1);
    periodicImages images(unitSquare(true));
    const label n = 20;
    const scalar h = 1.0/n;
    const labelVector size(n + 1, n + 1, 1);
    const cartesianBlock block(point(0, 0, 0), h, size, 2);
    surfaceDistance distance(3*h);
    distance.update(images.update(surfaces, 3*h), block);

    // All four corners of the square lie in the disc
    EXPECT_LT(distance.distance()[block.index(0, 0, 0)], -0.5*h);
    for (label i = 0; i <= n; ++i)
    {
        EXPECT_NEAR
        (
            distance.distance()[block.index(i, 0, 0)],
            distance.distance()[block.index(i, n, 0)],
            1e-14
        );
        EXPECT_NEAR
        (
            distance.distance()[block.index(0, i, 0)],
            distance.distance()[block.index(n, i, 0)],
            1e-14
        );
    }
}


namespace
{

//- Total contact force on the first of two rigid discs 0.21 apart, the second
//  moved by a vector, in a square cyclic in both directions or in none
vector forceOnFirst(const vector& shift, const periodicImages& images)
{
    surfaceSet surfaces(2);
    const point first(0.05, 0.5, 0);
    const point second(first - vector(0.21, 0.02, 0) + shift);
    appendDisc(surfaces, first, 0.1);
    appendDisc(surfaces, second, 0.1);
    contactBodies bodies;
    bodies.reset(surfaces);
    bodies.areas() = 0.02;
    forAll(surfaces.points(), i)
    {
        const label objecti = surfaces.pointObject()[i];
        const bool begins = i == surfaces.pointStart()[objecti];
        for (label d = 0; d < 2; ++d)
        {
            bodies.mode(i, begins ? bodies.addMode(objecti, 1) : d) = Zero;
            bodies.mode(i, d)[d] = 1;
        }
    }

    contact touch(dictionary(), 2, 0.02, 1e3, images);
    vectorField force;
    const contactStatistics& s = touch.calculate
    (
        surfaces,
        surfaces.velocities(),
        bodies,
        UList<contactWall>(),
        UList<medialAxisPoint>(),
        contactStep(1e-3),
        force
    );
    EXPECT_EQ(s.contacts, 1);
    EXPECT_NEAR(mag(sum(force)), 0, 1e-9);
    return sum(SubField<vector>(force, 24));
}

} // End anonymous namespace


TEST(periodicImages, carryContactThroughCyclicSides)
{
    const vector expected(forceOnFirst(Zero, periodicImages()));
    EXPECT_GT(mag(expected), 1e-3);
    const vector found
    (
        forceOnFirst(vector(1, 0, 0), unitSquare(true))
    );
    EXPECT_NEAR(mag(found - expected), 0, 1e-9*mag(expected));
}


// ************************************************************************* //
