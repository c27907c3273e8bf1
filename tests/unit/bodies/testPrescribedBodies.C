// SPDX-License-Identifier: GPL-3.0-or-later

#include "errorOf.H"
#include "mathematicalConstants.H"
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


TEST(prescribedBodies, turnAboutAPivot)
{
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 3), 3);
    const vector omega(0.4, -1.1, 0.7), pivot(0.5, -0.2, 0.1);
    const scalar angle = mag(omega);
    const vector axis(omega/angle);
    const auto group = moved
    (
        *shape,
        "type rotating; angularVelocity (0.4 -1.1 0.7); pivot (0.5 -0.2 0.1);",
        7
    );
    for (label i = 0; i < shape->nBoundaryNodes(); ++i)
    {
        const vector arm(shape->points()[i] - pivot);
        const vector along((arm & axis)*axis);
        const vector expected
        (
            start + pivot + along + std::cos(angle)*(arm - along)
          + std::sin(angle)*(axis ^ arm)
        );
        EXPECT_LT(mag(at(group->positions(), 3, i) - expected), 1e-13);
    }
}


TEST(prescribedBodies, followFunctionsOfTime)
{
    // A rotation whose axis changes: what counts are the first and last place
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 3), 3);
    const auto group = moved
    (
        *shape,
        "type function; displacement table ((0 (9 0 0)) (1 (10 2 3)));"
        "rotation table ((0 (0 0 0.5)) (0.5 (1 0 0.2)) (1 (0 1.2 0)));",
        8
    );
    for (label i = 0; i < shape->nBoundaryNodes(); ++i)
    {
        const vector& X = shape->points()[i];
        const scalar c = std::cos(0.5), s = std::sin(0.5);
        const vector back(c*X.x() + s*X.y(), c*X.y() - s*X.x(), X.z());
        const scalar C = std::cos(1.2), S = std::sin(1.2);
        const vector expected
        (
            C*back.x() + S*back.z(), back.y(), C*back.z() - S*back.x()
        );
        EXPECT_LT
        (
            mag
            (
                at(group->positions(), 3, i)
              - start - vector(1, 2, 3) - expected
            ),
            1e-13
        );
    }
}


TEST(prescribedBodies, severalMotionsAndTheirClocks)
{
    // Heave and pitch with a phase; a motion that begins at 0.2 s and is at
    // full speed 0.4 s later: 0.8 - 0.2 s of it are over after a second
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 3), 3);
    const auto group = moved
    (
        *shape,
        "type several; motions ("
        "{ type translating; velocity (5 0 0); start 0.2; ramp 0.4; }"
        "{ type oscillating; amplitude (0 2 0); frequency 0.25; phase 1; }"
        "{ type oscillating; rotationAmplitude (0 0 2); frequency 0.25; });",
        10
    );
    const scalar c = std::cos(2.0), s = std::sin(2.0);
    const vector shift
    (
        5*0.6, 2*(std::sin(0.5*constant::mathematical::pi + 1) - std::sin(1.0)),
        0
    );
    for (label i = 0; i < shape->nBoundaryNodes(); ++i)
    {
        const vector& X = shape->points()[i];
        const vector turned(c*X.x() - s*X.y(), s*X.x() + c*X.y(), X.z());
        EXPECT_LT
        (
            mag(at(group->positions(), 3, i) - start - shift - turned), 1e-13
        );
    }
}


TEST(prescribedBodies, wrongMotionsAreRefused)
{
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 3), 3);
    for
    (
        const string wrong :
        {
            "type oscillating; frequency 1;",
            "type function;",
            "type several; motions ();",
            "type several; motions ({ type free; });",
            "type several; motions ({ type fixed; pivot (1 0 0); });",
            "type rotating; angularVelocity (0 0 1); ramp -1;",
            "type rotating; angularVelocity (0 0 1); pivots (0 0 1);"
        }
    )
    {
        EXPECT_NE
        (
            errorOf
            (
                [&]{ bodyGroup::New(*shape, dictionaryOf(wrong)); }
            ).message,
            string()
        ) << wrong;
    }
}


// ************************************************************************* //
