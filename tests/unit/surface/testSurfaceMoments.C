// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "samples/surfaceSamples.H"
#include "surfaceMoments.H"

using namespace Foam;
using namespace Foam::fsi;


TEST(SurfaceMoments, ofABoxAreExact)
{
    // Octahedron of half-axes a: its moment along x is V a^2/10
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 0);
    for (point& p : surfaces.points())
    {
        p = point(3, 4, 5) + cmptMultiply(p, vector(2, 3, 1));
    }
    const surfaceMoments m(surfaces, 0, surfaces.centroid(0));
    const scalar V = 4.0/3*6;
    const symmTensor expected(4*V/10, 0, 0, 9*V/10, 0, V/10);
    EXPECT_NEAR(surfaces.volume(0), V, 1e-13);
    EXPECT_LT(mag(m.moments() - expected), 1e-12*V);

    // An ellipsoid has V a^2/5
    EXPECT_LT
    (
        mag(m.halfLengths() - vector(3, 2, 1)/Foam::sqrt(2.0)), 1e-12
    );
    EXPECT_LT(mag(m.longAxis() - vector(0, 1, 0)), 1e-12);
    EXPECT_NEAR(mag(m.shortAxis(3).z()), 1, 1e-12);
    EXPECT_NEAR(m.deformation(3), 0.5, 1e-12);
}


TEST(SurfaceMoments, turnWithTheSurface)
{
    // Long axis in the x-y plane at 30 degrees
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 3);
    const scalar c = std::sqrt(0.75), s = 0.5;
    const tensor R(c, -s, 0, s, c, 0, 0, 0, 1);
    for (point& p : surfaces.points())
    {
        p = R & vector(cmptMultiply(p, vector(1.2, 0.9, 1)));
    }
    const surfaceMoments m(surfaces, 0, surfaces.centroid(0));
    EXPECT_LT(mag(m.longAxis() - vector(c, s, 0)), 1e-10);
    EXPECT_LT(mag(m.shortAxis(3) - vector(s, -c, 0)), 1e-10);
    EXPECT_NEAR(m.deformation(3), 1.0/7, 1e-10);
}


TEST(SurfaceMoments, ofAnEllipseInThePlane)
{
    surfaceSet surfaces(2);
    appendDisc(surfaces, Zero, 1, 400);
    for (point& p : surfaces.points())
    {
        p = point(0.5*p.y(), 2*p.x(), 0.7);
    }
    // The turn changed the sense: areas are negative, moments must not mind
    pointField points(surfaces.points());
    reverse(points);
    surfaces.points() = points;
    const surfaceMoments m(surfaces, 0, surfaces.centroid(0));
    EXPECT_NEAR(m.halfLengths()[0], 2, 1e-3);
    EXPECT_NEAR(m.halfLengths()[1], 0.5, 1e-3);
    EXPECT_EQ(m.halfLengths()[2], 0);
    EXPECT_NEAR(m.deformation(2), 0.6, 1e-12);
    EXPECT_NEAR(mag(m.longAxis().y()), 1, 1e-12);
    EXPECT_NEAR(m.shortAxis(2).x(), 1, 1e-12);
}


// ************************************************************************* //
