// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidSamples.H"
#include "openfoamVersion.H"
#include "OStringStream.H"
#include "error.H"
#include "samples/newShapeTemplate.H"

#include <gtest/gtest.h>

using namespace rigidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Disc of radius 0.1 m, thickness 1 m
std::unique_ptr<shapeTemplate> softShape(const string& material)
{
    return newShapeTemplate
    (
        "disc",
        dictionaryOf
        (
            "shape { type circle; radius 0.1; } material { " + material + " }"
            " admm { iterations 300; tolerance 1e-13; }"
        ),
        0.03,
        1.0,
        2
    );
}


//- A copy that turns, stretched by a twentieth
autoPtr<bodyGroup> stretched(const shapeTemplate& shape)
{
    auto group = bodyGroup::New(shape, dictionary());
    group->append
    (
        point(0.2, 0.1, 0), tensor::I, vector(0.3, 0, 0), vector(0, 0, 2), 0
    );
    group->positions().col(0) = group->positions().col(0)*1.05;
    group->positions().col(1) = group->positions().col(1)/1.05;
    return group;
}


//- Steps of a quarter more and less than their mean in turn
class steps
{
    const scalar mean_;
    const bool vary_;
    scalar last_ = 0;
    label n_ = 0;

public:

    steps(const scalar mean, const bool vary) : mean_(mean), vary_(vary) {}

    //- A step under a force that turns with the time
    void advance(bodyGroup& group, const scalar strength)
    {
        const scalar dt =
            vary_ ? mean_*(n_ % 2 ? 0.75 : 1.25) : mean_;
        const scalar r = last_ > 0 ? dt/last_ : 0;
        const scalar tau = dt*(1 + r)/(1 + 2*r);
        last_ = dt;
        ++n_;
        group.begin(0, dt, r);
        group.prepareResponse(tau);

        // The force depends on the place alone, and each node has its own
        const Eigen::MatrixXd force(-strength*group.positions());
        Eigen::MatrixXd v;
        group.predict(0, tau, force, v);
        group.constrain(tau, v);
        group.move(tau, v);
    }
};


//- Positions after 0.1 s in n steps
Eigen::MatrixXd placesAfter
(
    const shapeTemplate& shape,
    const scalar strength,
    const label n,
    const bool vary
)
{
    auto group = stretched(shape);
    steps run(0.1/n, vary);
    for (label i = 0; i < n; ++i)
    {
        run.advance(group(), strength);
    }
    return group->positions();
}


//- Order of positions between n, 2 n and 4 n steps
scalar orderOf
(
    const shapeTemplate& shape,
    const scalar strength,
    const label n,
    const bool vary
)
{
    const Eigen::MatrixXd a(placesAfter(shape, strength, n, vary));
    const Eigen::MatrixXd b(placesAfter(shape, strength, 2*n, vary));
    const Eigen::MatrixXd c(placesAfter(shape, strength, 4*n, vary));
    return std::log2((a - b).norm()/(b - c).norm());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests  * * * * * * * * * * * * * * * * * //

TEST(secondOrder, elasticBodies)
{
    for
    (
        const char* material :
        {
            "density 1000; E 200;",
            "type neoHookean; density 1000; E 200;"
        }
    )
    {
        auto shape = softShape(material);
        EXPECT_GT(orderOf(*shape, 20, 80, false), 1.8) << material;
        EXPECT_GT(orderOf(*shape, 20, 80, true), 1.8) << material;
    }
}


TEST(secondOrder, rigidBodies)
{
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 2), 2);
    EXPECT_GT(orderOf(*shape, 500, 20, false), 1.8);
    EXPECT_GT(orderOf(*shape, 500, 20, true), 1.8);
}


TEST(secondOrder, freeTop)
{
    auto shape = rigidShape(blockSurface(vector(0.3, 0.2, 0.1), 3), 3);
    List<Eigen::MatrixXd> found;
    for (const label n : {100, 200, 400})
    {
        auto group = bodyGroup::New(*shape, dictionary());
        group->append(Zero, tensor::I, Zero, vector(0.3, 5, 0.4), 0);
        const vector L(group->angularMomentum(0));
        steps run(1.0/n, false);
        for (label i = 0; i < n; ++i)
        {
            run.advance(group(), 0);
        }
        EXPECT_LT(mag(group->angularMomentum(0) - L), 1e-10*mag(L));
        found.append(group->positions());
    }
    EXPECT_GT
    (
        std::log2
        (
            (found[0] - found[1]).norm()/(found[1] - found[2]).norm()
        ),
        1.8
    );
}


TEST(secondOrder, stateGoesOn)
{
    auto shape = softShape("density 1000; E 200;");
    auto group = stretched(*shape);
    steps run(0.005, false);
    run.advance(group(), 20);
    run.advance(group(), 20);

    OStringStream os;
    group->write(os);
    auto copy = bodyGroup::New(*shape, dictionary());
    copy->read(dictionaryOf(os.str()));
    steps same(run);
    run.advance(group(), 20);
    same.advance(copy(), 20);
    EXPECT_TRUE(group->positions() == copy->positions());
    EXPECT_TRUE(group->velocities() == copy->velocities());
}


TEST(secondOrder, newCopiesAndRemovedOnes)
{
    auto shape = softShape("density 1000; E 200;");
    auto group = stretched(*shape);
    steps run(0.005, false);
    run.advance(group(), 0);
    group->append(Zero, tensor::I, vector(1, 0, 0), Zero, 1);
    run.advance(group(), 0);
    EXPECT_NEAR(group->velocity(1).x(), 1, 1e-10);
    EXPECT_NEAR(group->centroid(1).x(), 0.005, 1e-10);

    const Eigen::MatrixXd second(group->positions().rightCols(2));
    group->remove(labelList({0}));
    EXPECT_TRUE(group->positions() == second);
    run.advance(group(), 0);
    EXPECT_NEAR(group->centroid(0).x(), 0.01, 1e-10);
}


TEST(secondOrder, viscousBodiesAreRefused)
{
    for
    (
        const char* material :
        {
            "density 1000; E 2e4; viscosity 1;",
            "density 1000; E 2e4; springLaw { type KelvinVoigt; viscosity 1; }",
            "density 1000; E 2e4; springLaw { type Maxwell; viscosity 1; }"
        }
    )
    {
        auto shape = softShape(material);
        auto group = stretched(*shape);
        EXPECT_THROW(group->begin(0, 0.01, 0), Foam::error) << material;
    }
}


// ************************************************************************* //
