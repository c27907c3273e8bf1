// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const string rubber("density 1000; E 1e4;");
const string neoHookean("type neoHookean; density 1000; E 1e4;");
const List<string> schemes({"ADMM", "quasiNewton"});


//- Implicit Euler by Newton's method with a Jacobian from differences
Eigen::VectorXd newton
(
    const shapeTemplate& shape,
    const bodyGroup& start,
    const Eigen::MatrixXd& force,
    const scalar dt
)
{
    const label n = 2*shape.nNodes();
    auto trial = groupOf(shape);
    trial->append(Zero, tensor::I, Zero, Zero, 0);
    Eigen::Map<Eigen::VectorXd> x(trial->positions().data(), n);
    const Eigen::Map<const Eigen::VectorXd> x0(start.positions().data(), n);
    const Eigen::Map<const Eigen::VectorXd> v0(start.velocities().data(), n);
    const Eigen::Map<const Eigen::VectorXd> f(force.data(), n);

    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape.nodeMasses().cdata(), n/2
    );
    const Eigen::VectorXd m = masses.replicate(2, 1);
    const Eigen::VectorXd inertial =
        x0 + dt*v0 + dt*dt*f.cwiseQuotient(m);
    Eigen::MatrixXd internal;
    auto residual = [&]()
    {
        trial->internalForce(internal);
        const Eigen::Map<const Eigen::VectorXd> g(internal.data(), n);
        return Eigen::VectorXd
        (
            m.cwiseProduct(x - inertial) - dt*dt*g
        );
    };

    x = x0 + dt*v0;
    for (label iteration = 0; iteration < 12; ++iteration)
    {
        const Eigen::VectorXd r = residual();
        Eigen::MatrixXd jacobian(n, n);
        const scalar step = 1e-7*shape.nodeSpacing();
        for (label j = 0; j < n; ++j)
        {
            const scalar old = x[j];
            x[j] = old + step;
            const Eigen::VectorXd up = residual();
            x[j] = old - step;
            jacobian.col(j) = (up - residual())/(2*step);
            x[j] = old;
        }
        x -= jacobian.partialPivLu().solve(r);
    }
    return (x - x0)/dt;
}


//- Compare a step with Newton's
void expectNewtons(const string& material, const string& scheme)
{
    auto shape = disc
    (
        material,
        "scheme " + scheme
      + "; iterations 5000; tolerance 1e-14; rotation implicitEuler;",
        0.04
    );
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, vector(0.3, 0.1, 0), vector(0, 0, 4), 0);

    // A strained start
    group->positions().col(0) *= 1.1;
    group->positions().col(1) *= 0.93;
    const Eigen::MatrixXd force = unevenForce(*group, 20);

    for (const scalar dt : {2e-3, 2e-2})
    {
        Eigen::MatrixXd v;
        group->predict(0, dt, force, v);
        const Eigen::VectorXd reference = newton(*shape, *group, force, dt);
        const Eigen::Map<const Eigen::VectorXd> found(v.data(), v.size());
        EXPECT_LT
        (
            (found - reference).cwiseAbs().maxCoeff()*dt,
            1e-8*shape->nodeSpacing()
        ) << "dt = " << dt;

        // The force does act: this is not a rigid motion
        EXPECT_GT(found.cwiseAbs().maxCoeff(), 0.1);
    }
}

//- Push an inner node out of its triangles and let it go
void expectTurnsBack(const string& scheme)
{
    auto shape = disc(rubber, "scheme " + scheme + ";", 0.03);
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);

    const label node = shape->nNodes() - 1;
    group->positions()(node, 0) += 1.5*shape->nodeSpacing();
    auto smallest = [&]()
    {
        scalar volume = GREAT;
        shapeMesh now(shape->mesh());
        forAll(now.points, i)
        {
            now.points[i].x() = group->positions()(i, 0);
            now.points[i].y() = group->positions()(i, 1);
        }
        return min(min(now.elementVolumes()), volume);
    };
    EXPECT_LT(smallest(), 0);
    run(*group, Eigen::MatrixXd::Zero(shape->nNodes(), 2), 1e-2, 200);
    EXPECT_GT(smallest(), 0.5*min(shape->mesh().elementVolumes()));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(admm, convergesToNewtonsImplicitEuler)
{
    for (const string& scheme : schemes)
    {
        expectNewtons(rubber, scheme);
        expectNewtons(neoHookean, scheme);
    }
}


TEST(admm, bodyAtRestStaysExactly)
{
    for (const string& scheme : schemes)
    {
        for (const string& material : {rubber, neoHookean})
        {
            auto shape = disc(material, "scheme " + scheme + ";");
            auto group = groupOf(*shape);
            group->append(Zero, tensor::I, Zero, Zero, 0);
            const Eigen::MatrixXd start = group->positions();
            run(*group, Eigen::MatrixXd::Zero(shape->nNodes(), 2), 1e-2, 20);
            EXPECT_EQ((group->positions() - start).cwiseAbs().maxCoeff(), 0);
            EXPECT_EQ(group->velocities().cwiseAbs().maxCoeff(), 0);
        }
    }
}


TEST(admm, doesNotDependOnTheDirection)
{
    auto shape = disc(rubber);
    const scalar angle = 0.7;
    const tensor turn
    (
        std::cos(angle), -std::sin(angle), 0,
        std::sin(angle), std::cos(angle), 0,
        0, 0, 1
    );
    auto straight = groupOf(*shape);
    auto turned = groupOf(*shape);
    const vector v(1, 0.4, 0), omega(0, 0, 5);
    straight->append(Zero, tensor::I, v, omega, 0);
    turned->append(Zero, turn, turn & v, omega, 0);

    Eigen::Matrix2d R;
    R << turn.xx(), turn.xy(), turn.yx(), turn.yy();
    const Eigen::MatrixXd force = unevenForce(*straight, 5);
    run(*straight, force, 5e-3, 10);
    run(*turned, force*R.transpose(), 5e-3, 10);

    EXPECT_GT(straight->elasticEnergy(), 1e-3*straight->kineticEnergy());
    EXPECT_LT
    (
        (straight->positions()*R.transpose() - turned->positions())
            .cwiseAbs().maxCoeff(),
        1e-11*0.1
    );
}


TEST(admm, oneFactorisationForAThousandCopies)
{
    auto shape = disc(rubber, "", 0.04);
    auto group = groupOf(*shape);
    for (label i = 0; i < 1000; ++i)
    {
        group->append(point(i, 0, 0), tensor::I, vector(i, 0, 0), Zero, i);
    }
    const Eigen::MatrixXd force = unevenForce(*group, 1);
    Eigen::MatrixXd v;
    for (label step = 0; step < 3; ++step)
    {
        group->predict(0, 1e-2, force, v);
        group->prepareResponse(1e-2);
        group->move(1e-2, v);
    }
    EXPECT_EQ(shape->nFactorisations(), 1);

    // The last few time steps are kept
    for (label repeat = 0; repeat < 3; ++repeat)
    {
        for (const scalar dt : {1e-2, 2e-2, 4e-2, 8e-2})
        {
            shape->factor(dt);
        }
    }
    EXPECT_EQ(shape->nFactorisations(), 4);
}


TEST(admm, copiesDoNotFeelEachOther)
{
    // Any number of copies, so any division into blocks, gives the same bits
    auto shape = disc(rubber);
    auto all = groupOf(*shape);
    for (label i = 0; i < 15; ++i)
    {
        all->append(point(i, 0, 0), tensor::I, vector(1, 0, 0), Zero, i);
    }
    const Eigen::MatrixXd force = unevenForce(*all, 10);
    run(*all, force, 5e-3, 3);

    for (const label copyi : {0, 7, 8, 12, 14})
    {
        auto one = groupOf(*shape);
        one->append(point(copyi, 0, 0), tensor::I, vector(1, 0, 0), Zero, 0);
        run(*one, force.middleCols(2*copyi, 2), 5e-3, 3);
        const Eigen::MatrixXd difference =
            one->positions() - all->positions().middleCols(2*copyi, 2);
        EXPECT_EQ(difference.cwiseAbs().maxCoeff(), 0) << "copy " << copyi;
    }
}


TEST(admm, toleranceEndsTheIteration)
{
    auto loose = disc(rubber, "iterations 1000; tolerance 1e-3;");
    auto tight = disc(rubber, "iterations 1000; tolerance 1e-9;");
    Eigen::MatrixXd v[2];
    label n[2];
    for (label i = 0; i < 2; ++i)
    {
        const shapeTemplate& shape = i ? *tight : *loose;
        auto group = groupOf(shape);
        group->append(Zero, tensor::I, Zero, Zero, 0);
        admmSolver solver(shape);
        solver.solve
        (
            1e-2,
            {
                group->positions(),
                group->velocities(),
                unevenForce(*group, 10),
                Eigen::MatrixXd()
            },
            v[i]
        );
        n[i] = solver.nIterations();
    }
    EXPECT_LT(n[0], n[1]);
    EXPECT_LT(n[1], 1000);

    // Where a step changes by the tolerance and each by less than half of the
    // one before, less than twice the tolerance is left
    EXPECT_LT(1e-2*(v[0] - v[1]).cwiseAbs().maxCoeff(), 2*1e-2*0.02);
}


TEST(admm, invertedElementsTurnBack)
{
    for (const string& scheme : schemes)
    {
        expectTurnsBack(scheme);
    }
}


// ************************************************************************* //
