// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidSamples.H"

#include <gtest/gtest.h>

using namespace rigidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const point start(1, 2, 3);

//- The block after a second in some steps, from `start`, under large forces
autoPtr<bodyGroup> moved
(
    const shapeTemplate& shape,
    const string& motion,
    const label nSteps
)
{
    auto group = bodyGroup::New(shape, dictionaryOf(motion));
    EXPECT_FALSE(group->movesFreely());
    group->append(start, tensor::I, Zero, Zero, 0);
    const Eigen::MatrixXd force
    (
        Eigen::MatrixXd::Constant(shape.nNodes(), 3, 1e9)
    );
    const scalar dt = 1.0/nSteps;
    for (label i = 0; i < nSteps; ++i)
    {
        Eigen::MatrixXd v;
        group->prepareResponse(dt);
        group->predict(i*dt, dt, force, v);
        group->constrain(dt, v);
        group->move(dt, v);
    }
    return group;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(prescribedBodies, turnAboutAnyAxis)
{
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 3), 3);
    const vector omega(0.4, -1.1, 0.7);
    const vector axis(omega/mag(omega));
    for (const label nSteps : {1, 7, 100})
    {
        const auto group = moved
        (
            *shape, "type rotating; angularVelocity (0.4 -1.1 0.7);", nSteps
        );
        for (label i = 0; i < shape->nBoundaryNodes(); ++i)
        {
            // The part along the axis stays, the rest turns in its plane
            const vector& X = shape->points()[i];
            const vector along((X & axis)*axis);
            const vector expected
            (
                start + along + std::cos(mag(omega))*(X - along)
              + std::sin(mag(omega))*(axis ^ X)
            );
            EXPECT_LT(mag(at(group->positions(), 3, i) - expected), 1e-13);
        }
    }
}


TEST(prescribedBodies, translateAndOscillateInSpace)
{
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 3), 3);
    const auto translated = moved
    (
        *shape, "type translating; velocity (3 -1 2);", 10
    );
    const auto oscillated = moved
    (
        *shape,
        "type oscillating; amplitude (0.1 0.2 -0.3); frequency 0.25;",
        10
    );
    for (label i = 0; i < shape->nBoundaryNodes(); ++i)
    {
        const vector at0(start + shape->points()[i]);
        EXPECT_LT
        (
            mag(at(translated->positions(), 3, i) - at0 - vector(3, -1, 2)),
            1e-13
        );
        EXPECT_LT
        (
            mag
            (
                at(oscillated->positions(), 3, i) - at0
              - vector(0.1, 0.2, -0.3)
            ),
            1e-13
        );
    }
}


// ************************************************************************* //
