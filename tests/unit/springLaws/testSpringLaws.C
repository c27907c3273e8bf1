// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// E = 1e4 Pa and eta = 2e3 Pa s: the time scale is 0.2 s. The mass is so small
// that inertia does not count.
const scalar E = 1e4, tau = 0.2, dt = tau/100, stress = 10;

std::unique_ptr<shapeTemplate> sample(const word& law)
{
    const string viscosity(law == "Hookean" ? "" : "viscosity 2e3; ");
    return bodyOf
    (
        latticeBar(12, 6, 0.1),
        0.1,
        "density 1e-3; E 1e4; areaStiffness 0; calibration vanGelder; "
        "springLaw { type " + law + "; " + viscosity + "}",
        "iterations 2000; tolerance 1e-11;"
    );
}


//- Strain along x after a time under constant stress
scalar creep(const word& law, const scalar time)
{
    auto shape = sample(law);
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    run(*group, traction(*shape, stress, 0, 0), dt, label(time/dt + 0.5));
    return meanStrain(*group)[0];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(springLaw, HookeanDoesNotCreep)
{
    EXPECT_NEAR(creep("Hookean", tau), stress/E, 0.02*stress/E);
}


TEST(springLaw, KelvinVoigtCreepsTowardsTheElasticStrain)
{
    for (const scalar time : {0.5*tau, tau, 2*tau})
    {
        const scalar expected = stress/E*(1 - std::exp(-time/tau));
        EXPECT_NEAR(creep("KelvinVoigt", time), expected, 0.02*expected);
    }
}


TEST(springLaw, MaxwellCreepsWithoutEnd)
{
    for (const scalar time : {0.5*tau, tau, 2*tau})
    {
        const scalar expected = stress/E*(1 + time/tau);
        EXPECT_NEAR(creep("Maxwell", time), expected, 0.02*expected);
    }
}


TEST(springLaw, MaxwellRelaxesAtConstantStrain)
{
    auto shape = sample("Maxwell");
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    group->positions().col(0) *= 1.001;
    const Eigen::MatrixXd still = 0*group->positions();

    Eigen::MatrixXd force;
    group->internalForce(force);
    const scalar first = force.norm();
    const scalar energy = group->elasticEnergy();
    EXPECT_GT(first, 0);
    for (label step = 1; step <= 200; ++step)
    {
        group->move(dt, still);
        if (step % 50 == 0)
        {
            group->internalForce(force);
            const scalar expected = first*std::exp(-step*dt/tau);
            EXPECT_NEAR(force.norm(), expected, 0.02*expected);
            EXPECT_NEAR
            (
                group->elasticEnergy(),
                energy*sqr(force.norm()/first),
                1e-6*energy
            );
        }
    }
}


TEST(springLaw, KelvinVoigtDampsAndMaxwellForgets)
{
    // After a stretch and its release the first returns, the second does not
    auto kelvinVoigt = sample("KelvinVoigt");
    auto maxwell = sample("Maxwell");
    scalar left[2];
    for (label i = 0; i < 2; ++i)
    {
        auto group = groupOf(i ? *maxwell : *kelvinVoigt);
        group->append(Zero, tensor::I, Zero, Zero, 0);
        const Eigen::MatrixXd pull = traction(group->shape(), stress, 0, 0);
        run(*group, pull, dt, 100);
        run(*group, 0*pull, dt, 1000);
        left[i] = meanStrain(*group)[0]*E/stress;
    }
    EXPECT_NEAR(left[0], 0, 0.01);
    EXPECT_NEAR(left[1], 1, 0.02);
}


TEST(springLaw, oneFactorForEachTimeStepWhateverTheLaw)
{
    for (const word law : {"Hookean", "KelvinVoigt", "Maxwell"})
    {
        auto shape = sample(law);
        auto group = groupOf(*shape);
        group->append(Zero, tensor::I, Zero, Zero, 0);
        run(*group, traction(*shape, stress, 0, 0), dt, 5);
        EXPECT_EQ(shape->nFactorisations(), 1) << law;
    }
}


// ************************************************************************* //
