// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar dt = 5e-3;

//- A moving, deformed body that is not symmetric, at two places
std::unique_ptr<bodyGroup> deformed(const shapeTemplate& shape)
{
    auto group = groupOf(shape);
    for (label i = 0; i < 3; ++i)
    {
        group->append(point(i, 2, 0), tensor::I, vector(1, i, 0), Zero, i);
    }
    run(*group, unevenForce(*group, 20), dt, 5);
    group->prepareResponse(dt);
    return group;
}


//- Response to the force of the given seed
Eigen::MatrixXd response(const bodyGroup& group, const Eigen::MatrixXd& force)
{
    Eigen::MatrixXd v;
    group.response().respond(force, v);
    return v;
}


//- Gradient of the volume of each copy by differences
Eigen::MatrixXd volumeGradient(bodyGroup& group)
{
    Eigen::MatrixXd g = 0*group.positions();
    const scalar step = 1e-4;
    for (label j = 0; j < g.cols(); ++j)
    {
        for (label i = 0; i < group.shape().nBoundaryNodes(); ++i)
        {
            scalar& x = group.positions()(i, j);
            const scalar old = x;
            x = old + step;
            const scalar up = group.volume(j/2);
            x = old - step;
            g(i, j) = (up - group.volume(j/2))/(2*step);
            x = old;
        }
    }
    return g;
}


//- Sum over all nodes of a copy
scalar dot
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b,
    const label copyi
)
{
    return a.middleCols(2*copyi, 2).cwiseProduct(b.middleCols(2*copyi, 2))
        .sum();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(response, isSymmetricAndPositive)
{
    auto shape = disc("density 1000; E 1e4;");
    auto group = deformed(*shape);
    const Eigen::MatrixXd a = unevenForce(*group, 1);
    const Eigen::MatrixXd b = a.reverse();
    const Eigen::MatrixXd va = response(*group, a), vb = response(*group, b);
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(dot(b, va, i), dot(a, vb, i), 1e-12*dot(a, va, i));
        EXPECT_GT(dot(a, va, i), 0);
    }
}


TEST(response, keepsMomentumAngularMomentumAndVolume)
{
    auto shape = disc("density 1000; E 1e4;");
    auto group = deformed(*shape);
    const Eigen::MatrixXd force = unevenForce(*group, 3);
    const Eigen::MatrixXd v = response(*group, force);
    const Eigen::MatrixXd gradient = volumeGradient(*group);
    const Eigen::MatrixXd& x = group->positions();

    for (label c = 0; c < 3; ++c)
    {
        vector impulse(Zero), momentum(Zero);
        scalar torque = 0, moment = 0;
        forAll(shape->nodeMasses(), i)
        {
            const scalar m = shape->nodeMasses()[i];
            const vector F(force(i, 2*c), force(i, 2*c + 1), 0);
            const vector p(m*v(i, 2*c), m*v(i, 2*c + 1), 0);
            impulse += dt*F;
            momentum += p;
            torque += dt*(x(i, 2*c)*F.y() - x(i, 2*c + 1)*F.x());
            moment += x(i, 2*c)*p.y() - x(i, 2*c + 1)*p.x();
        }
        EXPECT_LT(mag(momentum - impulse), 1e-12*mag(impulse));
        EXPECT_NEAR(moment, torque, 1e-12*mag(torque));

        const scalar size = std::sqrt(dot(v, v, c)*dot(gradient, gradient, c));
        EXPECT_NEAR(dot(v, gradient, c), 0, 1e-10*size);
    }
}


TEST(response, ofAStiffBodyIsThatOfARigidOne)
{
    auto shape = disc("density 1000; E 1e12;");
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    group->prepareResponse(dt);

    // One force at a boundary node
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(shape->nNodes(), 2);
    const point& p = shape->points()[3];
    const vector F(2, -5, 0);
    force(3, 0) = F.x();
    force(3, 1) = F.y();
    const Eigen::MatrixXd v = response(*group, force);

    const point c = group->centroid(0);
    scalar inertia = 0;
    forAll(shape->points(), i)
    {
        inertia += shape->nodeMasses()[i]*magSqr(shape->points()[i] - c);
    }
    const vector omega = dt*((p - c)^F)/inertia;
    forAll(shape->points(), i)
    {
        const vector expected =
            dt*F/shape->mass() + (omega^(shape->points()[i] - c));
        EXPECT_NEAR(v(i, 0), expected.x(), 1e-6*mag(F)*dt/shape->mass());
        EXPECT_NEAR(v(i, 1), expected.y(), 1e-6*mag(F)*dt/shape->mass());
    }
}


TEST(response, onTheBoundaryIsTheSame)
{
    auto shape = disc("density 1000; E 1e4;");
    auto group = deformed(*shape);
    const label nB = shape->nBoundaryNodes();
    const Eigen::MatrixXd force = unevenForce(*group, 3);
    const Eigen::MatrixXd v = response(*group, force);

    Eigen::MatrixXd boundary;
    group->response().respondBoundary(force.topRows(nB), boundary);
    EXPECT_LT
    (
        (boundary - v.topRows(nB)).cwiseAbs().maxCoeff(),
        1e-12*v.cwiseAbs().maxCoeff()
    );
}


TEST(response, ofTheSolverAndTheMatrixAgree)
{
    auto shape = disc("density 1000; E 1e4;");
    const admmFactor& factor = shape->factor(dt);
    Eigen::MatrixXd x = Eigen::MatrixXd::Random(shape->nNodes(), 19);
    const Eigen::MatrixXd b = factor.matrix()*x;
    Eigen::MatrixXd solved(b);
    factor.solve(solved);
    EXPECT_LT((solved - x).cwiseAbs().maxCoeff(), 1e-12);

    // A 1 = M 1
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(shape->nNodes());
    const Eigen::VectorXd sums = factor.matrix()*ones;
    EXPECT_NEAR(sums.sum(), shape->mass(), 1e-12*shape->mass());

    const Eigen::MatrixXd inverse =
        Eigen::MatrixXd(factor.matrix()).inverse();
    const label nB = shape->nBoundaryNodes();
    EXPECT_LT
    (
        (inverse.topLeftCorner(nB, nB) - factor.boundaryInverse())
            .cwiseAbs().maxCoeff(),
        1e-12*inverse.cwiseAbs().maxCoeff()
    );
}


TEST(response, volumeIsRestoredWithoutChangeOfMomentum)
{
    auto shape = disc("density 1000; E 1e4;");
    auto group = deformed(*shape);
    Eigen::MatrixXd v = response(*group, unevenForce(*group, 3));
    v.col(0) += 0.3*group->positions().col(0);
    group->velocities() = v;
    const vector momentum = group->momentum(0);
    const vector angular = group->angularMomentum(0);

    group->constrain(dt, v);
    EXPECT_GT((group->velocities() - v).cwiseAbs().maxCoeff(), 1e-3);

    group->velocities() = v;
    EXPECT_LT(mag(group->momentum(0) - momentum), 1e-12*mag(momentum));
    EXPECT_NEAR
    (
        group->angularMomentum(0).z(),
        angular.z(),
        1e-12*mag(angular) + 1e-13
    );
    group->move(dt, v);
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(group->volume(i)/shape->referenceVolume(), 1, 1e-13);
    }
}


// ************************************************************************* //
