// SPDX-License-Identifier: GPL-3.0-or-later

#include "insideFraction.H"
#include "mathematicalConstants.H"
#include "membraneGapLimit.H"
#include "nodesInside.H"
#include "samples/outlines.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;
const scalar radius = 4e-6;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(outlines, partOfACellInsideAnOutline)
{
    staggeredLattice box;
    box.origin = point(-8e-6, -8e-6, 0);
    box.spacing = 1e-6;
    box.nDims = 2;
    box.all = labelVector(16, 16, 1);
    box.cyclic = false;
    box.cyclic[0] = true;
    box.start = labelVector::zero;
    box.n = box.all;
    const auto inside = [&](const shapeMesh& mesh, const vector& shift)
    {
        scalarField fraction(box.size(), Zero), values(fraction);
        insideFraction(box).add
        (
            mesh.points + shift, mesh.faces, 3, fraction, values
        );
        EXPECT_NEAR(sum(values), 3*sum(fraction), 1e-12);
        EXPECT_GE(min(fraction), -1e-12);
        EXPECT_LE(max(fraction), 1 + 1e-12);
        return sum(fraction);
    };
    const label n = 200;
    const scalar area = 0.5*n*16*std::sin(2*pi/n);
    const shapeMesh mesh(ring(radius, n));
    EXPECT_NEAR(inside(mesh, point(0.3e-6, 0.1e-6, 0.5)), area, 0.01*area);

    // Across the cyclic side
    EXPECT_NEAR(inside(mesh, point(7e-6, 0.1e-6, 0.5)), area, 0.01*area);
}


TEST(outlines, nodesInOtherOutlines)
{
    const vector shift(1.3*radius, 0.2*radius, 0);
    const shapeMesh mesh(ring(radius, 50));
    surfaceSet surfaces(2);
    surfaces.append(mesh.points, mesh.faces);
    surfaces.append(mesh.points + shift, mesh.faces);
    label n = 0;
    for (const point& p : mesh.points)
    {
        n += mag(p - shift) < radius*std::cos(pi/50);
    }
    EXPECT_GT(n, 5);
    EXPECT_EQ(nodesInside(surfaces, vector::zero).ofMembranes, 0);
    surfaces.setImmersed(0, true);
    EXPECT_EQ(nodesInside(surfaces, vector::zero).ofMembranes, n);
}


TEST(outlines, nodesNearOtherOutlinesAreFound)
{
    // Two squares, turned by 45 degrees; the right corner of the first one is
    // a tenth of its half width from a side of the second one
    const shapeMesh mesh(ring(radius, 4));
    surfaceSet surfaces(2);
    surfaces.append(mesh.points, mesh.faces);
    surfaces.append(mesh.points, mesh.faces);
    for (label i = 4; i < 8; ++i)
    {
        const point& p = mesh.points[i - 4];
        surfaces.points()[i] =
            point(p.x() - p.y(), p.x() + p.y(), 0)
          + point(2.1*radius, 0.3*radius, 0);
    }
    surfaces.setImmersed(0, true);
    surfaces.setImmersed(1, true);
    membraneGaps gaps(vector::zero, radius);
    gaps.find(surfaces, 2, 0.2*radius);
    ASSERT_EQ(gaps.pairs().size(), 1);
    const membraneGaps::pair& p = gaps.pairs()[0];
    EXPECT_EQ(p.node, 0);
    EXPECT_NEAR(p.gap, 0.1*radius, 1e-9*radius);
    EXPECT_NEAR(p.normal.x(), -1, 1e-9);

    // They come together with speed 1, and may come nearer by radius/20
    vectorField v(8, vector::zero), changes(v);
    v[0] = vector(1, 0, 0);
    membraneGapLimit
    (
        surfaces, gaps.pairs(), 0.1*radius, 0.05*radius, v
    ).addChanges(v, changes);
    v += changes;
    const scalar wall = surfaces.interpolate(v, p.face, p.weights).x();
    EXPECT_NEAR(v[0].x() - wall, 0.5, 1e-9);
    EXPECT_NEAR(mag(sum(changes)), 0, 1e-9);
}


// ************************************************************************* //
