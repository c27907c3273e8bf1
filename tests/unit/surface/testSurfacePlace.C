// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "surfacePlace.H"
#include "surfaceSet.H"
#include "samples/surfaceSamples.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- The square of the least distance of a point to the faces
scalar leastSquare(const surfaceSet& surfaces, const point& p)
{
    scalar least = GREAT;
    forAll(surfaces.faces(), facei)
    {
        FixedList<scalar, 3> weights;
        least =
            min(least, magSqr(surfaces.nearestOnFace(facei, p, weights) - p));
    }
    return least;
}

} // End anonymous namespace


TEST(SurfacePlace, goesOnOverTheEdgesOfTriangles)
{
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 3);

    // A point over each face is sought from one of the faces around it
    label nElsewhere = 0;
    forAll(surfaces.faces(), facei)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label start = surfaces.faceAcross(facei, i);
            ASSERT_GE(start, 0);
            const surfaceFace& f = surfaces.faces()[facei];
            const point p =
                0.37*(surfaces.points()[f[0]] + surfaces.points()[f[1]]
              + surfaces.points()[f[2]]);
            label found;
            const surfacePlace place =
                nearestPlace(surfaces, p, start, -1, found);
            const point x = surfaces.interpolate
            (
                surfaces.points(), place.face, place.weights
            );
            EXPECT_NEAR(magSqr(x - p), leastSquare(surfaces, p), 1e-14);
            nElsewhere += found != start;
        }
    }
    EXPECT_EQ(nElsewhere, 3*surfaces.faces().size());
}


TEST(SurfacePlace, aPointThatIsNotANumberIsAnError)
{
    // Not a search without an end
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 2);
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    label found;
    EXPECT_THROW
    (
        nearestPlace(surfaces, point(0, nan, 0), 0, 1, found),
        Foam::error
    );
}


TEST(SurfacePlace, goesOnOverTheNodesOfTriangles)
{
    // The way from a face far away leads over nodes, where no face across an
    // edge is nearer, but another one about the node is
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 4);
    const point p(1.1*normalised(vector(0.3, -0.5, 0.8)));
    const scalar least = leastSquare(surfaces, p);
    label n = 0;
    forAll(surfaces.faces(), facei)
    {
        const vector normal(surfaces.areaNormal(facei));
        if ((normal & p) > 0.5*mag(normal))
        {
            label found;
            const surfacePlace place =
                nearestPlace(surfaces, p, facei, -1, found);
            const point x = surfaces.interpolate
            (
                surfaces.points(), place.face, place.weights
            );
            EXPECT_NEAR(magSqr(x - p), least, 1e-14);
            ++n;
        }
    }
    EXPECT_GT(n, 400);
}


TEST(SurfacePlace, imagesKnowTheirOwnEdges)
{
    surfaceSet surfaces(3);
    appendSphere(surfaces, Zero, 1, 0);
    const label n = surfaces.faces().size();
    appendSphere(surfaces, point(3, 0, 0), 1, 0);
    surfaces.appendImages(labelList(1, 1), List<vector>(1, vector(9, 0, 0)));
    for (label facei = 0; facei < n; ++facei)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label across = surfaces.faceAcross(facei, i);
            EXPECT_EQ(surfaces.faceAcross(facei + n, i), across + n);
            EXPECT_EQ(surfaces.faceAcross(facei + 2*n, i), across + 2*n);
        }
    }
}
