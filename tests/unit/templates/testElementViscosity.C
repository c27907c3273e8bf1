// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementViscosity.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// The time scale is viscosity over shear modulus, 5 E/19 (theory.md, (3.24));
// the mass is so small that inertia does not count
const scalar E = 1e4, viscosity = 1e3, shearModulus = 5*E/19;
const scalar tau = viscosity/shearModulus;
const string material
(
    "type neoHookean; density 1e-3; E 1e4; viscosity 1e3;"
);


//- Shear of a bar after a time under constant shear stress
scalar shearAfter(const scalar time, const scalar stress, const label nSteps)
{
    auto shape = bodyOf
    (
        latticeBar(12, 6, 0.1), 0.1, material, "iterations 200; tolerance 1e-9;"
    );
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    run(*group, traction(*shape, 0, 0, stress), time/nSteps, nSteps);
    return 2*meanStrain(*group)[2];
}


//- A stretched and turned disc
std::unique_ptr<bodyGroup> stretchedDisc
(
    const shapeTemplate& shape,
    const scalar stretch = 1.6
)
{
    auto group = groupOf(shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    Eigen::MatrixXd& x = group->positions();
    x.col(0) *= stretch;
    x.col(1) /= stretch;
    const Eigen::MatrixXd old(x);
    x.col(0) = 0.8*old.col(0) - 0.6*old.col(1);
    x.col(1) = 0.6*old.col(0) + 0.8*old.col(1);
    return group;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(elementViscosity, creepsAsKelvinVoigt)
{
    const scalar stress = 10;
    for (const scalar periods : {0.5, 1.0, 2.0})
    {
        const scalar expected = stress/shearModulus*(1 - std::exp(-periods));
        EXPECT_NEAR
        (
            shearAfter(periods*tau, stress, label(1600*periods)),
            expected,
            0.02*expected
        );
    }
}


TEST(elementViscosity, convergesWithTheFirstOrderOfTheTimeStep)
{
    const scalar stress = 10;
    const scalar expected = stress/shearModulus*(1 - std::exp(-1.0));
    scalar error[3];
    for (label i = 0; i < 3; ++i)
    {
        error[i] = mag(shearAfter(tau, stress, 200 << i) - expected);
    }
    EXPECT_GT(error[0]/error[1], 1.8);
    EXPECT_GT(error[1]/error[2], 1.8);
}


//- The copy of which the groups consist
static const labelRange onlyCopy(0, 1);


TEST(elementViscosity, dissipatesTwoEtaESquaredInTheStretchedBody)
{
    auto shape = disc(material, "", 0.02);
    auto group = stretchedDisc(*shape);
    const Eigen::MatrixXd& x = group->positions();

    // Velocity gradient (1, 3; -1, -1): e = (1, 1; 1, -1), e:e = 4
    Eigen::MatrixXd v(x.rows(), 2);
    v.col(0) = x.col(0) + 3*x.col(1);
    v.col(1) = -x.col(0) - x.col(1);
    Eigen::MatrixXd force = 0*x;
    elementViscosity::addForce(*shape, x, v, onlyCopy, force);

    const scalar expected =
        8*viscosity*shape->referenceVolume()*shape->thickness();
    EXPECT_NEAR(-force.cwiseProduct(v).sum(), expected, 1e-9*expected);
}


TEST(elementViscosity, hasNoForceAndTorqueAndDoesNotFeelRotations)
{
    auto shape = disc(material, "", 0.02);
    auto group = stretchedDisc(*shape);
    const Eigen::MatrixXd& x = group->positions();
    Eigen::MatrixXd v = unevenForce(*group, 1);
    Eigen::MatrixXd force = 0*x;
    elementViscosity::addForce(*shape, x, v, onlyCopy, force);
    const scalar size = force.norm();
    EXPECT_GT(size, 0);
    EXPECT_LT(force.colwise().sum().norm(), 1e-12*size);
    EXPECT_LT
    (
        mag(x.col(0).dot(force.col(1)) - x.col(1).dot(force.col(0))),
        1e-12*size
    );

    v.col(0) = 0.3 - 2*x.col(1).array();
    v.col(1) = 2*x.col(0);
    force.setZero();
    elementViscosity::addForce(*shape, x, v, onlyCopy, force);
    EXPECT_LT(force.norm(), 1e-11*viscosity*shape->thickness());
}


TEST(elementViscosity, aStretchedBodyComesToRest)
{
    auto shape = disc("type neoHookean; density 1000; E 1e4; viscosity 1e3;");
    // The viscosity's matrix is too small beyond a stretch of 4
    for (const scalar stretch : {1.6, 6.0})
    for (const scalar dt : {0.01*tau, 0.1*tau, tau})
    {
        auto group = stretchedDisc(*shape, stretch);
        const Eigen::MatrixXd none = 0*group->positions();
        const scalar start = group->elasticEnergy();
        scalar energy = start;
        for (scalar time = 0; time < 20*tau + 100*dt; time += dt)
        {
            run(*group, none, dt, 1);
            energy = group->elasticEnergy() + group->kineticEnergy();
            EXPECT_LT(energy, start);
        }
        EXPECT_LT(energy, 1e-9*start);
    }
}


// ************************************************************************* //
