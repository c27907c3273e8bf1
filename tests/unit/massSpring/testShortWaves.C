// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Resistance to short waves of a surface.

\*---------------------------------------------------------------------------*/

#include "samples.H"
#include "mathematicalConstants.H"
#include "shortWaves.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

using namespace samples;

constexpr scalar viscosity = 3;

//- Force on the boundary nodes of a shape of thickness 1 moving with v
vectorField forceOn(const shapeTemplate& shape, const vectorField& v)
{
    vectorField force(v.size(), Zero);
    const scalar friction = shortWaves::friction(viscosity, 1);
    for (const auto& row : shortWaves::rows(shape))
    {
        shortWaves::addForce(row, 0, friction, v, force);
    }
    return force;
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

} // End namespace

// ************************************************************************* //
