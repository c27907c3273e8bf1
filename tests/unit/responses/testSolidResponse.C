// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/solidSamples.H"
#include "bodyGroup.H"

#include <gtest/gtest.h>

using namespace solidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar dt = 5e-3;

//- A body of 125 nodes that is not regular
std::unique_ptr<shapeTemplate> block()
{
    return solidOf(unevenCube(4, 0.02), 0.02, "density 1000; E 1e4;");
}


//- Copies that are deformed at random, their response made
autoPtr<bodyGroup> deformed(const shapeTemplate& shape)
{
    autoPtr<bodyGroup> group(bodyGroup::New(shape, dictionary()));
    for (label i = 0; i < 2; ++i)
    {
        group->append(point(i, 2, 3), tensor::I, vector(1, i, 0), Zero, i);
    }
    Eigen::MatrixXd& x = group->positions();
    x += 0.1*shape.nodeSpacing()*Eigen::MatrixXd::Random(x.rows(), x.cols());
    group->prepareResponse(dt);
    return group;
}


//- Sum over all nodes of a copy
scalar dot
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b,
    const label copyi
)
{
    return rigidModes::product(a, b, 3, copyi);
}


//- Forces on all nodes
Eigen::MatrixXd someForce(const bodyGroup& group)
{
    const Eigen::MatrixXd& x = group.positions();
    return Eigen::MatrixXd::Random(x.rows(), x.cols());
}


//- Gradient of the volume of each copy by differences
Eigen::MatrixXd volumeGradient(bodyGroup& group)
{
    Eigen::MatrixXd g(0*group.positions());
    const scalar step = 1e-4*group.shape().nodeSpacing();
    for (label j = 0; j < g.cols(); ++j)
    {
        for (label i = 0; i < group.shape().nBoundaryNodes(); ++i)
        {
            scalar& x = group.positions()(i, j);
            const scalar old = x;
            x = old + step;
            const scalar up = group.volume(j/3);
            x = old - step;
            g(i, j) = (up - group.volume(j/3))/(2*step);
            x = old;
        }
    }
    return g;
}


//- Momentum and angular momentum about the origin of node values p
void addMoments
(
    const Eigen::MatrixXd& x,
    const Eigen::MatrixXd& p,
    const label copyi,
    vector& sum,
    vector& moment
)
{
    for (label i = 0; i < x.rows(); ++i)
    {
        vector arm, value;
        for (direction d = 0; d < 3; ++d)
        {
            arm[d] = x(i, 3*copyi + d);
            value[d] = p(i, 3*copyi + d);
        }
        sum += value;
        moment += arm ^ value;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solidResponse, rotationsAreOrthonormalWithTheMasses)
{
    auto shape = block();
    auto group = deformed(*shape);
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape->nodeMasses().cdata(), shape->nNodes()
    );
    const auto rotations =
        group->response().modesOf(bodyResponse::modeKind::rotation);
    ASSERT_EQ(rotations.size(), 3u);
    for (label copyi = 0; copyi < 2; ++copyi)
    {
        for (label k = 0; k < 3; ++k)
        {
            const Eigen::MatrixXd momenta
            (
                masses.asDiagonal()*rotations[k]->values
            );
            for (label l = 0; l < 3; ++l)
            {
                EXPECT_NEAR
                (
                    dot(rotations[l]->values, momenta, copyi), k == l, 1e-12
                );
            }
            const Eigen::RowVectorXd net(momenta.colwise().sum());
            EXPECT_LT(net.cwiseAbs().maxCoeff(), 1e-12*momenta.norm());
        }
    }
}


TEST(solidResponse, isSymmetricAndPositive)
{
    auto shape = block();
    auto group = deformed(*shape);
    const Eigen::MatrixXd a(someForce(*group)), b(someForce(*group));
    Eigen::MatrixXd va, vb;
    group->response().respond(a, va);
    group->response().respond(b, vb);
    for (label i = 0; i < 2; ++i)
    {
        EXPECT_NEAR(dot(b, va, i), dot(a, vb, i), 1e-11*dot(a, va, i));
        EXPECT_GT(dot(a, va, i), 0);
    }
}


TEST(solidResponse, keepsMomentumAngularMomentumAndVolume)
{
    auto shape = block();
    auto group = deformed(*shape);
    const Eigen::MatrixXd force(someForce(*group));
    Eigen::MatrixXd v;
    group->response().respond(force, v);
    const Eigen::MatrixXd gradient(volumeGradient(*group));
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape->nodeMasses().cdata(), shape->nNodes()
    );
    const Eigen::MatrixXd momenta(masses.asDiagonal()*v);

    for (label copyi = 0; copyi < 2; ++copyi)
    {
        vector impulse(Zero), torque(Zero), momentum(Zero), moment(Zero);
        const Eigen::MatrixXd& x = group->positions();
        addMoments(x, dt*force, copyi, impulse, torque);
        addMoments(x, momenta, copyi, momentum, moment);
        EXPECT_LT(mag(momentum - impulse), 1e-11*mag(impulse));
        EXPECT_LT(mag(moment - torque), 1e-11*mag(torque));

        // C' g = 0, as far as the differences tell g
        const scalar size = std::sqrt
        (
            dot(v, v, copyi)*dot(gradient, gradient, copyi)
        );
        EXPECT_LT(mag(dot(v, gradient, copyi)), 1e-7*size);
    }
    Eigen::MatrixXd none;
    group->response().respond(gradient, none);
    EXPECT_LT(none.norm(), 1e-6*v.norm()*gradient.norm()/force.norm());
}


TEST(solidResponse, onTheBoundaryIsTheSame)
{
    auto shape = block();
    auto group = deformed(*shape);
    const label nB = shape->nBoundaryNodes();
    Eigen::MatrixXd force(someForce(*group)), v, boundary;
    force.bottomRows(force.rows() - nB).setZero();
    group->response().respond(force, v);
    group->response().respondBoundary(force.topRows(nB), boundary);
    EXPECT_LT
    (
        (boundary - v.topRows(nB)).cwiseAbs().maxCoeff(),
        1e-11*v.cwiseAbs().maxCoeff()
    );
}


TEST(solidResponse, volumeIsRestoredWithoutChangeOfMomentum)
{
    auto shape = block();
    auto group = deformed(*shape);
    Eigen::MatrixXd v;
    group->response().respond(someForce(*group), v);
    v += 0.3*group->positions();
    group->velocities() = v;
    const vector momentum(group->momentum(0));
    const vector spin(group->angularMomentum(0));

    group->constrain(dt, v);
    EXPECT_GT((group->velocities() - v).cwiseAbs().maxCoeff(), 1e-3);
    group->velocities() = v;
    EXPECT_LT(mag(group->momentum(0) - momentum), 1e-11*mag(momentum));
    const scalar size =
        group->mass()*shape->nodeSpacing()*v.cwiseAbs().maxCoeff();
    EXPECT_LT(mag(group->angularMomentum(0) - spin), 1e-11*size);
    group->move(dt, v);
    for (label i = 0; i < 2; ++i)
    {
        EXPECT_NEAR(group->volume(i)/shape->referenceVolume(), 1, 1e-12);
    }
}


// ************************************************************************* //
