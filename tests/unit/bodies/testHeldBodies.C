// SPDX-License-Identifier: GPL-3.0-or-later

#include "heldSamples.H"

#include "error.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;
using namespace heldSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const string leftEnd
(
    "root { type box; min (-100 -100 -100); max (-19 100 100); }"
);

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(heldBodies, clampedBeamBendsAsTheory)
{
    // A bar of 40 x 4 about the origin, clamped in x < -19.5
    shapeMesh bar(samples::latticeBar(80, 8, 0.5));
    const point middle(20.125, 0.25*std::sqrt(3.0)*4, 0);
    scalar left = GREAT, right = -GREAT;
    for (point& p : bar.points)
    {
        p -= middle;
        right = max(right, p.x());
    }
    auto shape = heldShape(bar, rubber, leftEnd, 0.5);
    for (const label i : shape->held().clamped())
    {
        left = max(i == shape->held().clamped()[0] ? -GREAT : left,
            shape->points()[i].x());
    }
    auto group = copyOf(*shape);

    const scalar height = 2*std::sqrt(3.0), L = right - left;
    const scalar g = 1e-3;
    const scalar exact = 1.5*g*pow4(L)/(1e4*sqr(height));
    const Eigen::MatrixXd force(weight(*group, vector(0, g, 0)));
    samples::run(*group, force, 2, 600);

    scalar tip = -GREAT;
    forAll(shape->points(), i)
    {
        tip = max(tip, group->positions()(i, 1) - shape->points()[i].y());
    }
    EXPECT_NEAR(tip, exact, 0.04*exact);
    for (const label i : shape->held().clamped())
    {
        EXPECT_NEAR(group->positions()(i, 0), shape->points()[i].x(), 1e-7);
        EXPECT_NEAR(group->positions()(i, 1), shape->points()[i].y(), 1e-7);
    }
}


TEST(heldBodies, springsPullWithTheirForce)
{
    const scalar dt = 0.2, k = 30;
    const string all
    (
        "all { type halfSpace; point (-9 0 0); normal (1 0 0);"
        " stiffness 30; }"
    );
    for (const string& material : {rubber, string("density 2; type rigid;")})
    {
        auto shape =
            heldShape(samples::latticeBar(4, 3, 0.3), material, all, 0.3);
        auto group = copyOf(*shape);
        const label n = shape->held().nodes().size();
        group->positions().col(0).array() += 0.1;
        const Eigen::MatrixXd v
        (
            oneStep(*group, weight(*group, Zero), dt)
        );
        scalar momentum = 0, pull = 0;
        forAll(shape->nodeMasses(), i)
        {
            momentum += shape->nodeMasses()[i]*v(i, 0);
        }
        for (const label i : shape->held().nodes())
        {
            pull -= k/n*(0.1 + dt*v(i, 0));
        }
        EXPECT_NEAR(momentum, dt*pull, 1e-10*mag(momentum)) << material;
        EXPECT_LT(momentum, 0);
    }
}


TEST(heldBodies, oneClampedNodeIsAHinge)
{
    // A square of side 2 that hangs at the corner (-1, 1): I = 8 m/3 there
    const scalar dt = 1e-3, g = 9;
    const string hinge("pin { type nearest; point (-1 1 5); }");
    auto flat = heldShape
    (
        rigidSamples::blockSurface(vector(2, 2, 0), 2),
        "density 3; type rigid;", hinge
    );
    auto group = copyOf(*flat);
    Eigen::MatrixXd v(oneStep(*group, weight(*group, vector(0, -g, 0)), dt));
    const scalar omega = dt*g*3/8;
    EXPECT_NEAR(v(1, 0), -2*omega, 1e-6*omega);
    EXPECT_NEAR(v(1, 1), -2*omega, 1e-6*omega);
    EXPECT_NEAR(v(3, 1), 0, 1e-6*omega);

    // A block that turns about an edge along z
    auto solid = heldShape
    (
        rigidSamples::blockSurface(vector(2, 2, 2), 3),
        "density 3; type rigid;",
        "a { type nearest; point (-1 1 -1); }"
        " b { type nearest; point (-1 1 1); }"
    );
    auto block = copyOf(*solid);
    v = oneStep(*block, weight(*block, vector(0, -g, 0)), dt);
    forAll(solid->points(), i)
    {
        const point& x = solid->points()[i];
        EXPECT_NEAR(v(i, 0), omega*(x.y() - 1), 1e-6*omega);
        EXPECT_NEAR(v(i, 1), -omega*(x.x() + 1), 1e-6*omega);
        EXPECT_NEAR(v(i, 2), 0, 1e-6*omega);
    }

    // A disc of rubber turns about a node of its edge, I = 3 m r^2/2
    auto disc = newShapeTemplate
    (
        "disc",
        samples::dictionaryOf
        (
            "shape { type circle; radius 0.1; } material { " + rubber
          + " } hold { pin { type nearest; point (-0.1 0 0); } }"
        ),
        0.02, 1.0, 2
    );
    auto rubberDisc = copyOf(*disc);
    v = oneStep(*rubberDisc, weight(*rubberDisc, vector(0, -g, 0)), 0.01);
    rubberDisc->velocities() = v;
    EXPECT_NEAR
    (
        rubberDisc->velocity(0).y(), -2*0.01*g/3, 0.02*0.01*g
    );
    EXPECT_NEAR(v(disc->held().nodes()[0], 1), 0, 1e-7*0.01*g);
}


TEST(heldBodies, refusesBadInput)
{
    const shapeMesh bar(samples::latticeBar(4, 3, 0.3));
    for
    (
        const string& hold :
        {
            string("a { type cube; }"),
            string("a { type box; min (9 9 9); max (10 10 10); }"),
            string("a { type box; min (-9 -9 0); max (9 9 0); radius 1; }"),
            string("a { type nearest; point (0 0 0); stiffness -1; }"),
            string
            (
                "a { type nearest; point (0 0 0); }"
                " b { type nearest; point (0 0 0); stiffness 1; }"
            ),
            string("a 1;")
        }
    )
    {
        EXPECT_THROW(heldShape(bar, rubber, hold, 0.3), Foam::IOerror) << hold;
    }
}


// ************************************************************************* //
