// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Implicit Euler of bodies in 3D: what it solves, keeps and converges to.

\*---------------------------------------------------------------------------*/

#include "samples/solidSamples.H"

#include <gtest/gtest.h>

using namespace solidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4, rho = 1000, side = 0.1;
const string neoHookean("density 1000; E 1e4; ");
const string springs
(
    "type elastic; density 1000; E 1e4; calibration vanGelder; "
);
const List<string> materials
({
    neoHookean,
    springs,
    springs + "springLaw { type KelvinVoigt; viscosity 100; }",
    springs + "springLaw { type Maxwell; viscosity 1000; }",
    neoHookean + "viscosity 50;"
});
const List<string> schemes({"quasiNewton", "ADMM"});


//- Time step in which waves go so many spacings
scalar stepOf(const scalar reach)
{
    return reach*side/std::sqrt(E/rho);
}


//- Give all copies a velocity and a rotation that differ
void throwCopies(copies& body)
{
    for (label copyi = 0; copyi < body.x.cols()/3; ++copyi)
    {
        const Eigen::RowVector3d v(0.3, -0.1*copyi, 0.2);
        const Eigen::RowVector3d omega(1, 2 - copyi, -3);
        for (label i = 0; i < body.x.rows(); ++i)
        {
            const Eigen::RowVector3d x = body.x.block(i, 3*copyi, 1, 3);
            body.v.block(i, 3*copyi, 1, 3) = v + omega.cross(x);
        }
    }
}


//- Residual of (3.9) after a step of a strained body, over the load
scalar residual(const string& material, const string& admm, const scalar reach)
{
    const auto shape =
        solidOf(unevenCentredCube(3, side), side, material, admm);
    copies body(*shape);
    throwCopies(body);
    body.deform(Eigen::Vector3d(1.1, 0.97, 0.94).asDiagonal());
    const scalar dt = stepOf(reach);
    const Eigen::MatrixXd load = unevenForce(body, 0.02*E*sqr(side));
    const Eigen::MatrixXd before = body.v;
    body.v = body.predicted(dt, load);
    body.x += dt*body.v;
    Eigen::MatrixXd force = load;
    body.energy(&force);
    return
        (body.timesMasses(body.v - before)/dt - force).norm()
       /load.norm();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solidStep, convergesToImplicitEuler)
{
    for (const string& scheme : schemes)
    {
        for (const string& material : {neoHookean, springs})
        {
            for (const scalar reach : {0.2, 0.7, 3.0})
            {
                const string end("; rotation implicitEuler; scheme ");
                EXPECT_LT
                (
                    residual
                    (
                        material,
                        "iterations 5000; tolerance 1e-12" + end + scheme + ";",
                        reach
                    ),
                    1e-6
                ) << scheme << " " << material << " " << reach;
            }
        }
    }
}


TEST(solidStep, bodyAtRestStaysExactly)
{
    for (const string& scheme : schemes)
    {
        for (const string& material : materials)
        {
            const auto shape = solidOf
            (
                unevenCentredCube(3, side),
                side,
                material,
                "scheme " + scheme + ";"
            );
            copies body(*shape, 3);
            const Eigen::MatrixXd start = body.x;
            body.run(body.none(), stepOf(1), 5);
            EXPECT_EQ((body.x - start).norm(), 0) << scheme << material;
        }
    }
}


TEST(solidStep, keepsMomentumAndAngularMomentum)
{
    for (const string& scheme : schemes)
    {
        for (const string& material : materials)
        {
            for (const label iterations : {1, 4})
            {
                const auto shape = solidOf
                (
                    unevenCentredCube(3, side),
                    side,
                    material,
                    "scheme " + scheme
                  + "; iterations " + name(iterations) + ";"
                );
                copies body(*shape, 3);
                throwCopies(body);
                crumple(body, 0.05*side);
                const scalar dt = stepOf(0.5);
                const Eigen::MatrixXd force = unevenForce(body, 5);
                const Eigen::MatrixXd before =
                    body.timesMasses(body.v) + dt*force;
                const Eigen::MatrixXd after =
                    body.timesMasses(body.predicted(dt, force));
                for (label copyi = 0; copyi < 3; ++copyi)
                {
                    const auto expected = momenta(body.x, before, copyi);
                    const auto found = momenta(body.x, after, copyi);
                    EXPECT_LT
                    (
                        (found - expected).norm(), 1e-12*expected.norm()
                    ) << scheme << material << iterations;
                }
            }
        }
    }
}


// A body that turns about its axis of medium inertia turns over again and
// again, with the angular momentum that it had

TEST(solidStep, stiffBodiesTumbleForEver)
{
    const auto shape = solidOf
    (
        box(4, 2, 1, side), side, "density 1000; E 1e7;"
    );
    copies body(*shape);
    const Eigen::RowVector3d omega(0.01, 3, 0.02);
    for (label i = 0; i < body.x.rows(); ++i)
    {
        const Eigen::RowVector3d x = body.x.row(i);
        body.v.row(i) = omega.cross(x);
    }
    const auto start = momenta(body.x, body.timesMasses(body.v));
    const scalar energy = body.kineticEnergy();
    const Eigen::VectorXd arm = body.timesMasses(body.x.col(1));
    const scalar upright = arm.dot(body.x.col(1));
    scalar least = 1;
    for (label step = 0; step < 600; ++step)
    {
        body.run(body.none(), 0.01, 1);
        least = min(least, arm.dot(body.x.col(1))/upright);
    }
    EXPECT_LT(least, -0.9);
    const auto end = momenta(body.x, body.timesMasses(body.v));
    EXPECT_LT((end - start).norm(), 1e-10*start.norm());
    EXPECT_NEAR(body.kineticEnergy(), energy, 0.05*energy);
}


TEST(solidStep, implicitEulerLosesAngularMomentumAsItMust)
{
    const auto shape = solidOf
    (
        unevenCentredCube(3, side),
        side,
        neoHookean,
        "rotation implicitEuler; iterations 100; tolerance 1e-10;"
    );
    copies body(*shape);
    const scalar omega = 2, dt = 1e-2;
    const label n = 50;
    const Eigen::RowVector3d axis(0, 0, omega);
    for (label i = 0; i < body.x.rows(); ++i)
    {
        const Eigen::RowVector3d x = body.x.row(i);
        body.v.row(i) = axis.cross(x);
    }
    const auto size = [&]()
    {
        return momenta(body.x, body.timesMasses(body.v)).tail(3).norm();
    };
    const scalar before = size();
    body.run(body.none(), dt, n);
    const scalar after = size();
    EXPECT_NEAR(1 - after/before, n*sqr(omega*dt), 0.2*n*sqr(omega*dt));
}


TEST(solidStep, copiesDoNotFeelEachOther)
{
    for (const string& scheme : schemes)
    {
        for (const string& material : materials)
        {
            const auto shape = solidOf
            (
                unevenCentredCube(2, side),
                side,
                material,
                "scheme " + scheme + ";"
            );
            copies all(*shape, 15);
            throwCopies(all);
            const Eigen::MatrixXd force = unevenForce(all, 5);
            const Eigen::MatrixXd v = all.v;
            all.run(force, stepOf(0.5), 3);
            for (const label copyi : {0, 7, 8, 12, 14})
            {
                copies one(*shape);
                one.v = v.middleCols(3*copyi, 3);
                one.run(force.middleCols(3*copyi, 3), stepOf(0.5), 3);
                EXPECT_EQ((one.x - all.x.middleCols(3*copyi, 3)).norm(), 0)
                    << scheme << material << copyi;
            }
        }
    }
}


TEST(solidStep, doesNotDependOnTheDirection)
{
    const Eigen::Matrix3d R = Eigen::AngleAxis<scalar>
    (
        2, Eigen::Vector3d(1, 2, -1).normalized()
    ).toRotationMatrix();
    for (const string& material : materials)
    {
        const auto shape = solidOf(unevenCentredCube(3, side), side, material);
        copies straight(*shape), turned(*shape);
        throwCopies(straight);
        turned.deform(R);
        turned.v = straight.v*R.transpose();
        const Eigen::MatrixXd force = unevenForce(straight, 5);
        straight.run(force, stepOf(0.5), 10);
        turned.run(force*R.transpose(), stepOf(0.5), 10);
        EXPECT_LT
        (
            (straight.x*R.transpose() - turned.x).norm(), 1e-10*side
        ) << material;
        EXPECT_GT(straight.energy(), 1e-4*straight.kineticEnergy());
    }
}


// ************************************************************************* //
