// SPDX-License-Identifier: GPL-3.0-or-later

#include "deformableResponse.H"
#include "samples/membraneSamples.H"
#include "innerFlow.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Positions, velocities and forces of nodes move a membrane off its rest
void disturb(bodyGroup& group, const scalar size)
{
    for (label i = 0; i < group.shape().nNodes(); ++i)
    {
        const scalar x = group.positions()(i, 0), y = group.positions()(i, 1);
        group.positions()(i, 0) += size*x;
        group.positions()(i, 1) -= size*(y - 3*x*x);
        group.velocities()(i, 0) = 2*y + 0.1;
        group.velocities()(i, 1) = 30*x*y;
    }
}


//- Momentum and angular momentum about the origin of copy 0
FixedList<scalar, 3> momenta(const bodyGroup& group)
{
    FixedList<scalar, 3> sum(scalar(0));
    const Eigen::MatrixXd& x = group.positions();
    const Eigen::MatrixXd& v = group.velocities();
    for (label i = 0; i < x.rows(); ++i)
    {
        const scalar m = group.shape().nodeMasses()[i];
        sum[0] += m*v(i, 0);
        sum[1] += m*v(i, 1);
        sum[2] += m*(x(i, 0)*v(i, 1) - x(i, 1)*v(i, 0));
    }
    return sum;
}


//- Positions after the time 0.04 with the given number of steps
Eigen::MatrixXd positionsAfter(const shapeTemplate& shape, const label nSteps)
{
    auto group = cellOf(shape);
    disturb(*group, 0.05);
    const Eigen::MatrixXd force = Eigen::MatrixXd::Zero(shape.nNodes(), 2);
    run(*group, force, 0.04/nSteps, nSteps);
    return group->positions();
}


//- Turn the nodes, more so inside: the boundary by `turn`, the middle by twice
//  that
void swirl(bodyGroup& group, const scalar radius, const scalar turn)
{
    Eigen::MatrixXd& x = group.positions();
    for (label i = 0; i < x.rows(); ++i)
    {
        const scalar r = x.row(i).norm()/radius;
        const scalar angle = turn*(2 - r*r);
        const scalar c = std::cos(angle), s = std::sin(angle);
        const scalar x0 = x(i, 0), x1 = x(i, 1);
        x(i, 0) = c*x0 - s*x1;
        x(i, 1) = s*x0 + c*x1;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(membrane, fillingDissipatesAsTheClosedForm)
{
    // 2 mu e:e A of a disc; e = ((2 3) (3 -2)) 1/s; A of the polygon is 0.6 %
    // below that of the disc
    auto shape = membraneOf("0.1 0.1", typical);
    auto group = cellOf(*shape);
    const Eigen::MatrixXd x = group->positions();
    group->velocities().col(0) = 2*x.col(0) + 7*x.col(1);
    group->velocities().col(1) = -1*x.col(0) - 2*x.col(1);

    const scalar power = group->innerDissipation(0);
    const scalar perArea = 2*(2*4 + 2*9);
    EXPECT_NEAR(power, perArea*shape->referenceVolume(), 1e-10*power);
    EXPECT_NEAR(power, perArea*constant::mathematical::pi*0.01, 0.02*power);

    // Rigid motion dissipates nothing
    group->velocities().col(0) = -3*x.col(1);
    group->velocities().col(1) = 3*x.col(0);
    EXPECT_LT(group->innerDissipation(0), 1e-12*power);
}


TEST(membrane, fillingLosesTheEnergyThatItDissipates)
{
    // A step without elasticity: the loss is dt times the mean power up to
    // O(dt^2)
    auto shape = membraneOf
    (
        "0.1 0.1",
        "density 1000; stretchingModulus 1e-9; innerViscosity 1;"
    );
    auto group = cellOf(*shape);
    const Eigen::MatrixXd x = group->positions();
    group->velocities().col(0) = x.col(0);
    group->velocities().col(1) = -x.col(1);
    const scalar before = group->kineticEnergy();
    const scalar power = group->innerDissipation(0);

    const scalar dt = 1e-4;
    run(*group, Eigen::MatrixXd::Zero(x.rows(), 2), dt, 1);
    EXPECT_NEAR((before - group->kineticEnergy())/dt, power, 0.01*power);
}


TEST(membrane, fillingRemembersNoShear)
{
    auto shape = membraneOf("0.1 0.1", typical);
    auto group = cellOf(*shape);
    Eigen::MatrixXd& x = group->positions();
    Eigen::MatrixXd force;

    // Inner nodes anywhere: no force, no energy
    for (label i = shape->nBoundaryNodes(); i < x.rows(); ++i)
    {
        x(i, 0) += 0.005*std::sin(3.0*i);
        x(i, 1) += 0.005*std::cos(5.0*i);
    }
    group->internalForce(force);
    EXPECT_EQ(force.norm(), 0);
    EXPECT_EQ(group->elasticEnergy(), 0);
}


TEST(membrane, keepsMomentumAndAngularMomentum)
{
    auto shape = membraneOf("0.1 0.06", typical);
    auto group = cellOf(*shape);
    disturb(*group, 0.1);
    const FixedList<scalar, 3> before(momenta(*group));
    runClosed
    (
        *group, Eigen::MatrixXd::Zero(shape->nNodes(), 2), 2e-3, 50
    );
    const FixedList<scalar, 3> after(momenta(*group));
    const scalar size = std::sqrt(2*group->mass()*group->kineticEnergy());
    EXPECT_NEAR(after[0], before[0], 1e-11*size);
    EXPECT_NEAR(after[1], before[1], 1e-11*size);
    EXPECT_NEAR(after[2], before[2], 1e-12*size);
}


TEST(membrane, keepsItsAreaExactly)
{
    auto shape = membraneOf("0.1 0.05", typical + "restCurvature 0;");
    auto group = cellOf(*shape);
    disturb(*group, 0);
    for (label step = 0; step < 20; ++step)
    {
        runClosed(*group, unevenForce(*group, 0.05), 1e-2, 1);
        EXPECT_NEAR
        (
            group->volume(0),
            shape->referenceVolume(),
            1e-14*shape->referenceVolume()
        );
    }
}


TEST(membrane, energyFallsWithoutForces)
{
    // Steps far above the periods of stretching and bending, with the area
    // kept: without it a spinning body swells
    for (const scalar dt : {1e-3, 1e-2, 1e-1})
    {
        auto shape = membraneOf("0.1 0.05", typical);
        auto group = cellOf(*shape);
        disturb(*group, 0.1);
        const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(shape->nNodes(), 2);
        // The first step brings the area back
        runClosed(*group, none, dt, 1);
        scalar energy = group->kineticEnergy() + group->elasticEnergy();
        for (label step = 0; step < 40; ++step)
        {
            runClosed(*group, none, dt, 1);
            const scalar next =
                group->kineticEnergy() + group->elasticEnergy();
            EXPECT_LT(next, energy) << dt << " " << step;
            energy = next;
        }
    }
}


TEST(membrane, predictionAndResponseAreOneLinearMap)
{
    auto shape = membraneOf("0.1 0.05", typical);
    auto group = cellOf(*shape);
    disturb(*group, 0.1);
    const scalar dt = 1e-2;
    const Eigen::MatrixXd force = unevenForce(*group, 0.1);
    Eigen::MatrixXd with, without, change;
    group->prepareResponse(dt);
    group->predict(0, dt, 0*force, without);
    group->predict(0, dt, force, with);
    dynamic_cast<const deformableResponse&>(group->response()).respondFreely
    (
        force, change
    );
    EXPECT_LT((with - without - change).norm(), 1e-12*change.norm());

    // Both components between boundary nodes as on all nodes
    Eigen::MatrixXd all, boundary;
    group->response().respond(force, all);
    group->response().respondBoundary
    (
        force.topRows(shape->nBoundaryNodes()), boundary
    );
    EXPECT_LT
    (
        (all.topRows(shape->nBoundaryNodes()) - boundary).norm(),
        1e-11*all.norm()
    );
}


TEST(membrane, stepsConvergeToOneMotion)
{
    // First order: each halving of the step halves the change
    auto shape = membraneOf("0.1 0.06", typical);
    const Eigen::MatrixXd a = positionsAfter(*shape, 20);
    const Eigen::MatrixXd b = positionsAfter(*shape, 40);
    const Eigen::MatrixXd c = positionsAfter(*shape, 80);
    const Eigen::MatrixXd d = positionsAfter(*shape, 160);
    EXPECT_NEAR((a - b).norm()/(b - c).norm(), 2, 0.6);
    EXPECT_NEAR((b - c).norm()/(c - d).norm(), 2, 0.3);
}


TEST(membrane, thinTrianglesAreReplaced)
{
    auto shape = membraneOf("0.1 0.1", typical);
    auto group = cellOf(*shape);
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(shape->nNodes(), 2);
    for (label step = 0; step < 200; ++step)
    {
        swirl(*group, 0.1, 0.05);
        group->move(0, none);
        const List<bodyElement>& triangles = group->elements(0);
        ASSERT_EQ(triangles.size(), shape->elements().size());
        ASSERT_GT
        (
            innerFlow::quality(triangles, group->positions()),
            0.05
        ) << step;
    }
    EXPECT_FALSE(group->elements(0) == shape->elements());

    // They cover the inside: an affine flow dissipates as before
    const Eigen::MatrixXd x = group->positions();
    group->velocities().col(0) = x.col(1);
    group->velocities().col(1) = x.col(0);
    EXPECT_NEAR
    (
        group->innerDissipation(0),
        4*shape->referenceVolume(),
        1e-9*shape->referenceVolume()
    );
}


// ************************************************************************* //
