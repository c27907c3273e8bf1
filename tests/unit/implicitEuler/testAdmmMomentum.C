// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const string rubber("density 1000; E 1e4;");


//- Momentum of the input, M v^n + dt F, of a copy, and its moment about zero
vector inputMomentum
(
    const bodyGroup& group,
    const Eigen::MatrixXd& force,
    const scalar dt,
    const label copyi,
    scalar& moment
)
{
    vector sum(Zero);
    moment = 0;
    const scalarField& m = group.shape().nodeMasses();
    forAll(m, i)
    {
        const label c = 2*copyi;
        const scalar px = m[i]*group.velocities()(i, c) + dt*force(i, c);
        const scalar py =
            m[i]*group.velocities()(i, c + 1) + dt*force(i, c + 1);
        sum += vector(px, py, 0);
        moment +=
            group.positions()(i, c)*py - group.positions()(i, c + 1)*px;
    }
    return sum;
}


//- Compare the momenta after a step with what went in
void expectMomenta(const string& admm)
{
    auto shape = disc(rubber, admm);
    auto group = groupOf(*shape);
    for (label i = 0; i < 5; ++i)
    {
        const vector omega(0, 0, 2.0*i);
        group->append(point(i, 0, 0), tensor::I, vector(1, i, 0), omega, i);
    }
    const scalar dt = 5e-3;
    const Eigen::MatrixXd force = unevenForce(*group, 30);
    Eigen::MatrixXd v;
    group->predict(0, dt, force, v);

    auto after = groupOf(*shape);
    for (label i = 0; i < 5; ++i)
    {
        after->append(Zero, tensor::I, Zero, Zero, i);
    }
    after->positions() = group->positions();
    after->velocities() = v;
    const Eigen::MatrixXd none = 0*force;
    for (label i = 0; i < 5; ++i)
    {
        scalar moment, expectedMoment;
        const vector expected =
            inputMomentum(*group, force, dt, i, expectedMoment);
        const vector found = inputMomentum(*after, none, dt, i, moment);
        EXPECT_LT(mag(found - expected), 1e-12*mag(expected));
        EXPECT_NEAR(moment, expectedMoment, 1e-12*mag(expectedMoment));
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(admmMomentum, momentaAreExactAfterAnyNumberOfIterations)
{
    for (const string& scheme : {"ADMM", "quasiNewton"})
    {
        for (const label iterations : {1, 3, 10})
        {
            expectMomenta
            (
                "scheme " + scheme + "; iterations " + name(iterations) + ";"
            );
        }
    }
}


TEST(admmMomentum, stiffBodyTurnsForEver)
{
    // dt^2 k/m is about 500
    auto shape = disc("density 1000; E 1.2e7;", "", 0.0117);
    const scalar dt = 3e-3, omega = 20;
    const scalar stiffness =
        sqr(dt)*average(shape->springConstants())/shape->nodeMasses()[0];
    EXPECT_GT(stiffness, 400);

    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, vector(0, 0, omega), 0);
    const scalar L = group->angularMomentum(0).z();
    const scalar energy = group->kineticEnergy();

    const Eigen::MatrixXd force = Eigen::MatrixXd::Zero(shape->nNodes(), 2);
    Eigen::MatrixXd v;
    for (label step = 0; step < 2100; ++step)
    {
        group->predict(step*dt, dt, force, v);
        group->prepareResponse(dt);
        group->constrain(dt, v);
        group->move(dt, v);
    }

    // Twenty turns
    EXPECT_NEAR(group->angularMomentum(0).z(), L, 1e-9*L);
    EXPECT_NEAR(group->angularVelocity(0).z(), omega, 1e-3*omega);
    EXPECT_NEAR(group->kineticEnergy(), energy, 2e-3*energy);
    EXPECT_NEAR(group->volume(0), shape->referenceVolume(), 1e-14);
    EXPECT_LT(group->elasticEnergy(), 1e-3*energy);
}


TEST(admmMomentum, implicitEulerLosesAngularMomentumAsItMust)
{
    // The part (omega dt)^2 in each step
    auto shape = disc(rubber, "rotation implicitEuler; iterations 50;");
    auto group = groupOf(*shape);
    const scalar omega = 2, dt = 1e-2;
    group->append(Zero, tensor::I, Zero, vector(0, 0, omega), 0);
    const scalar L = group->angularMomentum(0).z();
    const label n = 100;
    run(*group, Eigen::MatrixXd::Zero(shape->nNodes(), 2), dt, n);

    const scalar loss = 1 - group->angularMomentum(0).z()/L;
    EXPECT_NEAR(loss, n*sqr(omega*dt), 0.1*n*sqr(omega*dt));
}


TEST(admmMomentum, freeFallIsExact)
{
    auto shape = disc(rubber);
    auto group = groupOf(*shape);
    group->append(point(0.4, 0.7, 0), tensor::I, vector(1, 0, 0), Zero, 0);
    const Eigen::MatrixXd start = group->positions();

    const scalar g = -9.81, dt = 1e-2;
    const label n = 50;
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(shape->nNodes(), 2);
    forAll(shape->nodeMasses(), i)
    {
        force(i, 1) = g*shape->nodeMasses()[i];
    }
    run(*group, force, dt, n);

    // Implicit Euler's sum of the velocities
    const scalar fall = g*dt*dt*n*(n + 1)/2;
    const Eigen::MatrixXd moved = group->positions() - start;
    EXPECT_LT((moved.col(0).array() - n*dt).abs().maxCoeff(), 1e-11);
    EXPECT_LT((moved.col(1).array() - fall).abs().maxCoeff(), 1e-11);
    EXPECT_LT(group->elasticEnergy(), 1e-18*group->kineticEnergy());
}


// ************************************************************************* //
