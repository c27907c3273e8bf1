// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "surfaceDistance.H"
#include "samples/surfaceSamples.H"
#include "triangleProjection.H"
#include "triangleReach.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The level set must be, to the last bit, that of all faces tried at all
//  samples in their order
static void checkAgainstAllFaces
(
    const surfaceSet& surfaces,
    const cartesianBlock& block,
    const scalar bandWidth
)
{
    surfaceDistance levelSet(bandWidth);
    levelSet.update(surfaces, block);

    const pointField& points = surfaces.points();
    scalarField distance(block.size(), sqr(bandWidth));
    labelList nearest(block.size(), -1);
    forAll(surfaces.faces(), facei)
    {
        const surfaceFace& f = surfaces.faces()[facei];
        const triangleProjection face
        (
            points[f[0]], points[f[1]], points[f[2]]
        );
        forAll(distance, samplei)
        {
            const scalar d = face.distanceSqr(block.position(samplei));
            if (d < (1 - 1e-10)*distance[samplei])
            {
                distance[samplei] = d;
                nearest[samplei] = facei;
            }
        }
    }

    label nBand = 0;
    forAll(distance, samplei)
    {
        ASSERT_EQ(levelSet.nearestFace()[samplei], nearest[samplei])
            << "sample at " << block.position(samplei).x() << ' '
            << block.position(samplei).y() << ' '
            << block.position(samplei).z();
        if (nearest[samplei] >= 0)
        {
            ASSERT_EQ
            (
                mag(levelSet.distance()[samplei]), sqrt(distance[samplei])
            );
            ++nBand;
        }
    }
    EXPECT_GT(nBand, 100);
}


//- A sphere whose radius is multiplied by a function of the direction
static surfaceSet dented
(
    const label nCuts,
    const std::function<scalar(const vector&)>& factor
)
{
    const point centre(0.51, 0.493, 0.507);
    surfaceSet surfaces(3);
    appendSphere(surfaces, centre, 0.3, nCuts);
    for (point& p : surfaces.points())
    {
        const vector r(p - centre);
        p = centre + factor(r/mag(r))*r;
    }
    return surfaces;
}


TEST(TriangleReach, SpheresCoarseAndFineAreThoseOfAllFaces)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    for (const label nCuts : {0, 1, 2, 3})
    {
        checkAgainstAllFaces
        (
            dented(nCuts, [](const vector&) { return 1; }),
            block,
            3*block.spacing()
        );
    }
}


// Ridges, grooves and saddles, from gentle to crumpled
TEST(TriangleReach, DentedSpheresAreThoseOfAllFaces)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    for (const scalar depth : {0.1, 0.3, 0.6})
    {
        const auto factor = [depth](const vector& n)
        {
            return 1 + depth*Foam::sin(7*n.x())*Foam::cos(5*n.y() + 3*n.z());
        };
        for (const label nCuts : {2, 3})
        {
            checkAgainstAllFaces
            (
                dented(nCuts, factor), block, 4*block.spacing()
            );
        }
    }
}


// Nodes scattered by half a radius: sharp edges and slivers of all kinds
TEST(TriangleReach, ScatteredNodesAreThoseOfAllFaces)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    label n = 0;
    const auto factor = [&n](const vector&)
    {
        n = (1103*n + 12345) % 65536;
        return 0.75 + 0.5*scalar(n)/65536;
    };
    for (label repeat = 0; repeat < 3; ++repeat)
    {
        checkAgainstAllFaces(dented(3, factor), block, 3*block.spacing());
    }
}


// A flat box cut finely, aligned with the samples and turned: faces side by
// side in a plane, right angles, and faces along all axes
TEST(TriangleReach, FlatBoxesAlignedAndTurnedAreThoseOfAllFaces)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    const scalar h = block.spacing();
    for (const scalar turn : {0.0, 0.4})
    {
        surfaceSet surfaces(3);
        appendSphere(surfaces, point::zero, 1, 3);
        for (point& p : surfaces.points())
        {
            const vector m(cmptMag(p));
            const vector q(p/max(m.x(), max(m.y(), m.z())));
            const vector r(7*h*q.x(), 6*h*q.y(), 1.5*h*q.z());
            p = block.position(labelVector(12, 11, 12)) + vector
            (
                Foam::cos(turn)*r.x() - Foam::sin(turn)*r.z(),
                r.y(),
                Foam::sin(turn)*r.x() + Foam::cos(turn)*r.z()
            );
        }
        checkAgainstAllFaces(surfaces, block, 3*h);
    }
}


// Two nodes in one place: faces without area, and nodes beside them
TEST(TriangleReach, FacesWithoutAreaHideNothing)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 24, 3));
    surfaceSet surfaces(dented(2, [](const vector&) { return 1; }));
    const surfaceFace& f = surfaces.faces()[40];
    surfaces.points()[f[0]] = surfaces.points()[f[1]];
    checkAgainstAllFaces(surfaces, block, 3*block.spacing());
}


TEST(TriangleReach, AReachIsSmallWhereTheSurfaceIsSmooth)
{
    const scalar h = 1.0/28;
    surfaceSet surfaces(3);
    appendSphere(surfaces, point(0.5, 0.5, 0.5), 8*h, 3);
    normalCones cones;
    cones.update(surfaces, 0);

    // Volumes, by thin rows: a box grown by 3 h holds some 340 h^3
    const cartesianBlock rows(cellCentres(vector::zero, 1, 28*4, 3));
    scalar volume = 0;
    scalar prisms = 0;
    forAll(surfaces.faces(), facei)
    {
        const triangleReach reach(surfaces, facei, cones, 3*h);
        prisms += 6*h*mag(surfaces.areaNormal(facei));
        for (label k = 0; k < rows.n().z(); ++k)
        {
            for (label j = 0; j < rows.n().y(); ++j)
            {
                scalar lower, upper;
                const point p(rows.position(labelVector(0, j, k)));
                if
                (
                    p.y() >= reach.bounds().min().y()
                 && p.y() <= reach.bounds().max().y()
                 && p.z() >= reach.bounds().min().z()
                 && p.z() <= reach.bounds().max().z()
                )
                {
                    reach.rows(p.y(), p.z(), lower, upper);
                    volume += max(upper - lower, 0.0)*sqr(rows.spacing());
                }
            }
        }
    }
    EXPECT_GT(volume, prisms);
    EXPECT_LT(volume, 3*prisms);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
