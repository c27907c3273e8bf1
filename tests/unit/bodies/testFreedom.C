// SPDX-License-Identifier: GPL-3.0-or-later

#include "heldSamples.H"

#include <gtest/gtest.h>

using namespace heldSamples;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(freedom, motionsThatAreHeldDoNotHappen)
{
    const string motion("type free; translations (y); rotations ();");
    for (const string& material : {rubber, string("density 2; type rigid;")})
    {
        auto shape = heldShape
        (
            samples::latticeBar(4, 3, 0.3), material, "", 0.3
        );
        auto group = copyOf(*shape, motion);
        const Eigen::MatrixXd force(samples::unevenForce(*group, 1));
        const scalar dt = 0.01;
        group->prepareResponse(dt);
        Eigen::MatrixXd response;
        group->response().respond(force, response);
        for (const Eigen::MatrixXd& v : {oneStep(*group, force, dt), response})
        {
            group->velocities() = v;
            const vector velocity(group->velocity(0));
            const scalar expected = dt*force.col(1).sum()/shape->mass();
            EXPECT_NEAR(velocity.x(), 0, 1e-10*mag(expected)) << material;
            EXPECT_NEAR(velocity.y(), expected, 1e-9*mag(expected));
            EXPECT_NEAR
            (
                group->angularVelocity(0).z(), 0, 1e-9*mag(expected)
            );
        }
    }
}


TEST(freedom, solidTurnsAboutOneAxis)
{
    auto shape = heldShape
    (
        rigidSamples::blockSurface(vector(3, 2, 1), 3),
        "density 3; type rigid;", ""
    );
    auto group = bodyGroup::New
    (
        *shape,
        samples::dictionaryOf("type free; translations (); rotations (z);")
    );
    // Skew, so that z is no principal axis
    const tensor skew(0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8);
    group->append(Zero, skew, Zero, vector(0, 0, 2), 0);
    const Eigen::MatrixXd x(group->positions());
    Eigen::MatrixXd v(oneStep(*group, weight(*group, vector(1, 2, 3)), 0.1));
    group->constrain(0.1, v);
    const Eigen::MatrixXd end(x + 0.1*v);
    EXPECT_LT(v.col(2).array().abs().maxCoeff(), 1e-13);
    for (Eigen::Index i = 0; i < x.rows(); ++i)
    {
        EXPECT_NEAR
        (
            end.row(i).head(2).norm(), x.row(i).head(2).norm(), 1e-13
        );
    }
    // L = I sin(angle)/dt
    EXPECT_NEAR
    (
        std::atan2(end(0, 1), end(0, 0)) - std::atan2(x(0, 1), x(0, 0)),
        std::asin(0.2), 1e-12
    );
    EXPECT_THROW
    (
        group->append(Zero, tensor::I, vector(1, 0, 0), Zero, 1), Foam::error
    );
}


TEST(freedom, refusesBadInput)
{
    const shapeMesh bar(samples::latticeBar(4, 3, 0.3));
    auto shape = heldShape(bar, rubber, "", 0.3);
    for
    (
        const string& motion :
        {
            string("translations (z);"), string("rotations (x);"),
            string("translations (x x);"),
            string("translations (); rotations ();")
        }
    )
    {
        EXPECT_THROW(copyOf(*shape, motion), Foam::IOerror) << motion;
    }
}


// ************************************************************************* //
