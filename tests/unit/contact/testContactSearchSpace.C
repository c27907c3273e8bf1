// SPDX-License-Identifier: GPL-3.0-or-later

// Searches among triangles

#include "searchCases.H"
#include "rigidSpheres.H"
#include "surfaceWinding.H"

namespace
{

//- Spheres that are squeezed and moved at random, some into each other
surfaceSet squeezedSpheres(const label n, const label nCuts)
{
    surfaceSet surfaces(3);
    randomNumbers random(4);
    for (label i = 0; i < n; ++i)
    {
        surfaceSet sphere(sphereAtOrigin(1, nCuts - i % 2));
        const vector size(vector::one + random.sample01<vector>());
        const vector place(4*random.sample01<vector>());
        for (point& x : sphere.points())
        {
            x = cmptMultiply(size, x)/2 + place;
        }
        surfaces.append(sphere.points(), sphere.faces());
    }
    return surfaces;
}


//- A thick shell of a ball with a slit, which faces itself
surfaceSet slitBall(const label nCuts)
{
    surfaceSet ball(sphereAtOrigin(1, nCuts));
    for (point& x : ball.points())
    {
        // The equator is drawn in, to a neck of a fifth of the radius
        const scalar depth = Foam::exp(-sqr(x.z()/0.15));
        x.x() *= 1 - 0.8*depth;
        x.y() *= 1 - 0.8*depth;
    }
    return ball;
}


//- A flat tetrahedron with sharp edges
surfaceSet sliver()
{
    surfaceSet surfaces(3);
    surfaces.append
    (
        pointField({{0, 0, 0}, {3, 0, 0}, {0.2, 1, 0}, {2.5, 0.3, 0.25}}),
        List<surfaceFace>({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    );
    return surfaces;
}

} // End anonymous namespace


TEST(ContactSearchSpace, findsWhatBruteForceFinds)
{
    const surfaceSet spheres(squeezedSpheres(14, 3));
    for (const scalar range : {0.1, 0.6})
    {
        const contactPairs expected(bruteForce(spheres, range, true));
        EXPECT_GT(expected.pairs.size(), 100);
        expectSame(contactsOf(spheres, range), expected);
    }
}


TEST(ContactSearchSpace, placesOfOneObjectThatFaceEachOther)
{
    const surfaceSet ball(slitBall(4));
    const contactPairs found(contactsOf(ball, 0.4));
    expectSame(found, bruteForce(ball, 0.4, true));
    EXPECT_GT(found.pairs.size(), 50);
    for (const contactPair& p : found.pairs)
    {
        EXPECT_GT(p.gap, 0);
        EXPECT_LT(mag(ball.points()[p.node].z()), 0.5);
    }
    EXPECT_EQ(contactsOf(sphereAtOrigin(1, 3), 0.8).pairs.size(), 0);
}


TEST(ContactSearchSpace, medialAxis)
{
    // Two spheres 0.2 apart; the axis between them is the plane x = 0
    surfaceSet surfaces(3);
    List<medialAxisPoint> axis;
    for (const scalar side : {-1, 1})
    {
        appendSphere(surfaces, point(1.1*side, 0, 0), 1, 3);
        axis.append
        (
            medialAxisPoint
            {
                point(0, 0.05*side, 0.1), 0.05, FixedList<label, 2>({0, 1})
            }
        );
    }
    expectAxisPairs(surfaces, axis, 20, 0.52);
}


TEST(ContactSearchSpace, gapIsNegativeInsideOnly)
{
    // Nodes anywhere about slivers and cups: the sign is that of the winding
    randomNumbers random(8);
    const std::vector<surfaceSet> bodies({sliver(), cup(2), slitBall(2)});
    for (const surfaceSet& body : bodies)
    {
        surfaceSet surfaces(body);
        const boundBox box(body.points(), false);
        List<surfaceFace> faces(1, surfaceFace({0, 1, 2}));
        for (label i = 0; i < 400; ++i)
        {
            pointField x(3);
            for (point& p : x)
            {
                p =
                    box.min()
                  + cmptMultiply(random.sample01<vector>(), box.span());
            }
            surfaces.append(x, faces);
        }
        label nInside = 0;
        for (const contactPair& p : contactsOf(surfaces, 0.3).pairs)
        {
            if (p.other == 0)
            {
                const point& x = surfaces.points()[p.node];
                const bool inside = contains(surfaces, 0, x);
                EXPECT_EQ(p.gap < 0, inside) << x.x() << ' ' << x.y();
                nInside += inside;
            }
        }
        EXPECT_GT(nInside, 20);
    }
}


// ************************************************************************* //
