// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/samples.H"
#include "errorOf.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Positions after n steps of a prescribed motion, from (1 2 0)
Eigen::MatrixXd moved
(
    const shapeTemplate& shape,
    const string& motion,
    const scalar dt,
    const label n
)
{
    auto group = bodyGroup::New(shape, dictionaryOf(motion));
    EXPECT_FALSE(group->movesFreely());
    group->append(point(1, 2, 0), tensor::I, Zero, Zero, 0);
    run(*group, Eigen::MatrixXd::Constant(shape.nNodes(), 2, 1e9), dt, n);
    return group->positions();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(motion, followsThePrescribedPath)
{
    auto shape = disc("density 1000; E 1e4;", "", 0.04);
    const Eigen::MatrixXd start = moved(*shape, "type fixed;", 0.1, 10);
    EXPECT_EQ(start(0, 0), 1 + shape->points()[0].x());

    const Eigen::MatrixXd translated =
        moved(*shape, "type translating; velocity (3 -1 0);", 0.1, 10);
    EXPECT_LT((translated.col(0) - start.col(0)).array().abs().maxCoeff(), 3.1);
    EXPECT_NEAR(translated(5, 0) - start(5, 0), 3, 1e-12);
    EXPECT_NEAR(translated(5, 1) - start(5, 1), -1, 1e-12);

    const scalar time = 0.7;
    const Eigen::MatrixXd oscillated = moved
    (
        *shape, "type oscillating; amplitude (0.25 0 0); frequency 0.25;",
        0.1, 7
    );
    const scalar expected =
        0.25*std::sin(constant::mathematical::twoPi*0.25*time);
    EXPECT_NEAR(oscillated(3, 0) - start(3, 0), expected, 1e-12);
    EXPECT_NEAR(oscillated(3, 1), start(3, 1), 1e-15);
}


TEST(motion, rotatingBodyKeepsItsShape)
{
    auto shape = disc("density 1000; E 1e4;", "", 0.04);
    const Eigen::MatrixXd turned = moved
    (
        *shape, "type rotating; angularVelocity (0 0 2);", 0.05, 20
    );
    scalar meanX = 0, meanY = 0;
    forAll(shape->points(), i)
    {
        const scalar share = shape->nodeMasses()[i]/shape->mass();
        meanX += share*shape->points()[i].x();
        meanY += share*shape->points()[i].y();
    }
    forAll(shape->points(), i)
    {
        const scalar x = shape->points()[i].x() - meanX;
        const scalar y = shape->points()[i].y() - meanY;
        const scalar c = std::cos(2.0), s = std::sin(2.0);
        EXPECT_NEAR(turned(i, 0), 1 + meanX + c*x - s*y, 1e-12);
        EXPECT_NEAR(turned(i, 1), 2 + meanY + s*x + c*y, 1e-12);
    }
}


TEST(motion, prescribedBodyDoesNotRespond)
{
    auto shape = disc("density 1000; E 1e4;", "", 0.04);
    auto group = bodyGroup::New(*shape, dictionaryOf("type fixed;"));
    group->append(Zero, tensor::I, Zero, Zero, 0);
    group->prepareResponse(1e-2);

    Eigen::MatrixXd force = Eigen::MatrixXd::Ones(shape->nNodes(), 2), v;
    group->response().respond(force, v);
    EXPECT_EQ(v.rows(), shape->nNodes());
    EXPECT_EQ(v.cwiseAbs().maxCoeff(), 0);
    group->response().respondBoundary
    (
        force.topRows(shape->nBoundaryNodes()), v
    );
    EXPECT_EQ(v.rows(), shape->nBoundaryNodes());
    EXPECT_EQ(v.cwiseAbs().maxCoeff(), 0);

    v = force;
    group->constrain(1e-2, v);
    EXPECT_EQ((v - force).cwiseAbs().maxCoeff(), 0);
}


TEST(motion, staysInThePlane)
{
    auto shape = disc("density 1000; E 1e4;", "", 0.04);
    for
    (
        const char* motion :
        {
            "type translating; velocity (1 0 0.5);",
            "type rotating; angularVelocity (1 0 0);",
            "type oscillating; amplitude (0 0 1); frequency 1;"
        }
    )
    {
        const std::string text
        (
            errorOf([&]() { moved(*shape, motion, 0.1, 1); }).message
        );
        EXPECT_NE(text.find("leaves the plane"), std::string::npos) << motion;
    }
}


TEST(motion, defaultIsFree)
{
    auto shape = disc("density 1000; E 1e4;", "", 0.04);
    EXPECT_TRUE(bodyGroup::New(*shape, dictionary())->movesFreely());
    EXPECT_TRUE
    (
        bodyGroup::New(*shape, dictionaryOf("type free;"))->movesFreely()
    );
}


// ************************************************************************* //
