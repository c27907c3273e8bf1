// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Resistance to short waves of a surface.

\*---------------------------------------------------------------------------*/

#include "samples/samples.H"
#include "samples/surfaceSamples.H"
#include "mathematicalConstants.H"
#include "randomNumbers.H"
#include "shortWaves.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

using namespace samples;

constexpr scalar viscosity = 3;

//- Force on the nodes of a surface moving with v
vectorField forceOn
(
    const pointField& x,
    const List<surfaceFace>& faces,
    const direction nDims,
    const vectorField& v
)
{
    vectorField force(v.size(), Zero);
    for (const auto& four : shortWaves::all(x, faces, nDims, 1))
    {
        four.addForce(0, four.friction(viscosity), v, force);
    }
    return force;
}


//- Force on the boundary nodes of a shape of thickness 1
vectorField forceOn(const shapeTemplate& shape, const vectorField& v)
{
    return forceOn(shape.points(), shape.faces(), 2, v);
}


//- n x n nodes of a lattice of triangles of the length 0.3, in a tilted plane;
//  nodes are thrown about by a part of it
surfaceSet patch(const label n, const scalar thrown)
{
    const scalar length = 0.3;
    const vector e1(0.8, 0, 0.6), e2(0, 1, 0);
    randomNumbers random(3);
    pointField x(n*n);
    List<surfaceFace> faces;
    for (label j = 0; j < n; ++j)
    {
        for (label i = 0; i < n; ++i)
        {
            const vector r(thrown*(random.sample01<vector>()));
            x[n*j + i] =
                length*((i + 0.5*j + r.x())*e1)
              + length*(Foam::sqrt(0.75)*j + r.y())*e2;
            const label k = n*j + i;
            if (i + 1 < n && j + 1 < n)
            {
                faces.append(surfaceFace({k, k + 1, k + n}));
                faces.append(surfaceFace({k + 1, k + n + 1, k + n}));
            }
        }
    }
    surfaceSet surfaces(3);
    surfaces.append(x, faces);
    return surfaces;
}


TEST(shortWaves, theShortestIsResistedAsByStokesFlow)
{
    const auto shape = disc("density 1; E 1;", "", 0.0196);
    const label n = shape->nBoundaryNodes();
    ASSERT_EQ(n % 2, 0);
    const scalar spacing = 0.2*constant::mathematical::pi/n;

    // The boundary nodes come in order
    vectorField v(n);
    forAll(v, i)
    {
        v[i] = vector(i % 2 ? -1 : 1, i % 2 ? -0.5 : 0.5, 0);
    }
    const vectorField force(forceOn(*shape, v));
    const scalar waveNumber = constant::mathematical::pi/spacing;
    forAll(v, i)
    {
        const vector stokes(-2*viscosity*waveNumber*v[i]*spacing);
        EXPECT_NEAR(mag(force[i] - stokes)/mag(stokes), 0, 1e-12);
    }
}


TEST(shortWaves, motionsOfTheWholeBodyAreNot)
{
    const auto shape = disc("density 1; E 1;", "", 0.01);
    const label n = shape->nBoundaryNodes();
    const vectorField along(n, vector(1, 2, 0));
    EXPECT_LT(max(mag(forceOn(*shape, along))), 1e-13);

    // The torque, over that of Stokes flow around a turning disc
    vectorField turning(n);
    forAll(turning, i)
    {
        const point& x = shape->mesh().points[i];
        turning[i] = vector(-x.y(), x.x(), 0);
    }
    const vectorField force(forceOn(*shape, turning));
    const scalar torque = -sum(force & turning);
    const scalar stokes = 4*constant::mathematical::pi*viscosity*sqr(0.1);
    EXPECT_GT(torque, 0);
    EXPECT_LT(torque, 1e-5*stokes);
}


TEST(shortWaves, noNetForceAndWorkIsTaken)
{
    const auto shape = disc("density 1; E 1;");
    vectorField v(shape->nBoundaryNodes());
    forAll(v, i)
    {
        v[i] = vector(std::sin(1.3*i*i), std::cos(2.1*i*i), 0);
    }
    const vectorField force(forceOn(*shape, v));
    EXPECT_LT(mag(sum(force)), 1e-13*sum(mag(force)));
    EXPECT_LT(sum(force & v), 0);
}


TEST(shortWaves, theShortestOfALatticeOfTrianglesIsResistedAsByStokesFlow)
{
    // Three values, 0 in sum, and rows that alternate
    const label n = 12;
    const scalar length = 0.3, root3 = Foam::sqrt(3.0);
    const scalar pi = constant::mathematical::pi;
    const surfaceSet surface(patch(n, 0));
    const vector values[3] = {{1, 0, 2}, {0.5, -3, 0}, {-1.5, 3, -2}};
    vectorField three(n*n), rows(n*n);
    forAll(three, k)
    {
        three[k] = values[(k % n + 2*(k/n)) % 3];
        rows[k] = (k/n) % 2 ? values[0] : -values[0];
    }
    const pointField& x = surface.points();
    const vectorField ofThree(forceOn(x, surface.faces(), 3, three));
    const vectorField ofRows(forceOn(x, surface.faces(), 3, rows));
    const scalar area = root3/2*sqr(length);
    for (label k = 3*n + 3; k < n*n - 3*n - 3; ++k)
    {
        if (k % n > 2 && k % n < n - 3)
        {
            const scalar stokes = 2*viscosity*area*4*pi/(3*length);
            EXPECT_LT(mag(ofThree[k] + stokes*three[k]), 1e-12);
            const scalar longer = 2*viscosity*area*2*pi/(root3*length);
            const scalar part = (ofRows[k] & rows[k])/magSqr(rows[k]);
            EXPECT_NEAR(-part/longer, 32/(27*root3), 1e-12);
        }
    }
}


TEST(shortWaves, motionsOfASurfaceInSpaceAreNot)
{
    // Linear along an uneven lattice
    const surfaceSet plane(patch(9, 0.4));
    const tensor G(1, 2, 3, -4, 0.5, 2, 1, 1, -3);
    const vectorField linear(vector(1, 2, 3) + (G & plane.points()));
    const vectorField none(forceOn(plane.points(), plane.faces(), 3, linear));
    EXPECT_LT(max(mag(none)), 1e-12);

    // The torque of a sphere, over that of Stokes flow; less with finer faces
    scalar last = 0.01;
    for (const label nCuts : {3, 4})
    {
        surfaceSet sphere(3);
        appendSphere(sphere, Zero, 1, nCuts);
        const pointField& x = sphere.points();
        const vectorField turning(vector(1, 2, -1) ^ x);
        const vectorField force(forceOn(x, sphere.faces(), 3, turning));
        EXPECT_LT(mag(sum(force)), 1e-12);
        const scalar power = -sum(force & turning);
        const scalar stokes = 8*constant::mathematical::pi*viscosity*6;
        EXPECT_GT(power, 0);
        EXPECT_LT(power/stokes, last);
        last = 0.3*power/stokes;
    }
}

} // End namespace

// ************************************************************************* //
