// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "membraneForces.H"
#include "samples/samples.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>
#include <random>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using constant::mathematical::pi;

const scalar Gs = 5e-6;

string material(const string& others)
{
    return "type membrane; density 1000; shearModulus 5e-6; " + others;
}


//- The body of a shape's surface
std::unique_ptr<shapeTemplate> sheetOf
(
    const string& shape,
    const string& others,
    const scalar spacing
)
{
    const dictionary dict
    (
        dictionaryOf
        (
            "shape { " + shape + " } material { " + material(others) + " }"
        )
    );
    const meshGrading grading((dictionary()));
    return std::make_unique<shapeTemplate>
    (
        "cell",
        dict,
        newShapeMesh(dict.subDict("shape"), 3, spacing, grading, false),
        spacing,
        1,
        3
    );
}


//- Copies of a shape, their nodes moved by parts of a length at random
std::unique_ptr<bodyGroup> movedCopies
(
    const shapeTemplate& shape,
    const label n,
    const scalar length
)
{
    std::unique_ptr<bodyGroup> group(groupOf(shape));
    std::mt19937 random(3);
    std::uniform_real_distribution<scalar> in(-length, length);
    for (label i = 0; i < n; ++i)
    {
        group->append(point(1e-5*i, 0, 0), tensor::I, Zero, Zero, i);
    }
    for (Eigen::Index i = 0; i < group->positions().size(); ++i)
    {
        group->positions().data()[i] += in(random);
    }
    return group;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(membraneForces, forceIsMinusTheSlopeOfTheEnergy)
{
    // Nine copies: a full set of lanes and one lane of the next
    const scalar spacing = 0.5e-6;
    for (const char* law : {"", "law neoHookean;", "law wormLikeChain;"})
    {
        const auto shape = sheetOf
        (
            "type biconcave; radius 2e-6;",
            string(law) + " bendingModulus 2e-19;",
            spacing
        );
        const auto group = movedCopies(*shape, 9, 0.1*spacing);
        Eigen::MatrixXd force;
        group->internalForce(force);
        std::mt19937 random(5);
        std::uniform_int_distribution<label> any(0, force.size() - 1);
        for (label i = 0; i < 20; ++i)
        {
            double& x = group->positions().data()[any(random)];
            const auto at = &x - group->positions().data();
            const scalar step = 1e-5*spacing, middle = x;
            x = middle + step;
            const scalar above = group->elasticEnergy();
            x = middle - step;
            const scalar below = group->elasticEnergy();
            x = middle;
            EXPECT_NEAR
            (
                force.data()[at],
                (below - above)/(2*step),
                1e-5*force.cwiseAbs().maxCoeff()
            );
        }
    }
}


TEST(membraneForces, noForceAtRestOrTurned)
{
    const auto shape = sheetOf
    (
        "type biconcave; radius 3.91e-6;", "bendingModulus 2e-19;", 0.5e-6
    );
    const auto group = groupOf(*shape);
    const tensor turn(0, -1, 0, 1, 0, 0, 0, 0, 1);
    group->append(point(1e-5, 2e-5, 0), turn, Zero, Zero, 0);
    Eigen::MatrixXd force;
    group->internalForce(force);
    EXPECT_NEAR(force.cwiseAbs().maxCoeff(), 0, 1e-8*Gs*0.5e-6);
    EXPECT_NEAR(group->elasticEnergy(), 0, 1e-12*Gs*1e-12);
}


TEST(membraneForces, bendingEnergyOfASphere)
{
    // A third of 8 pi kappa, whatever the radius, on a mesh of equal triangles:
    // of the curvature's square hinges leave out what depends on the number of
    // holes only. Unequal triangles have up to a third more
    const auto shape = sheetOf
    (
        "type sphere; radius 2e-6;",
        "bendingModulus 2e-19; restCurvature flat;",
        0.25e-6
    );
    const auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    EXPECT_NEAR(group->elasticEnergy()/(8*pi*2e-19), 1/3.0, 0.1);
}


TEST(membraneForces, ratioOfTheStretches)
{
    const auto shape = sheetOf("type sphere; radius 2e-6;", "", 0.5e-6);
    const scalar atRest = shape->sheet()->stiffness(shape->nodeSpacing(), 1);
    const auto group = movedCopies(*shape, 1, 0);
    const auto& body = dynamic_cast<const immersedBodies&>(*group);
    EXPECT_NEAR(body.stiffness()/atRest, 1, 1e-6);
    group->positions().col(0) *= 2;
    group->positions().rightCols(2) *= std::sqrt(0.5);
    // K = 3 G_s counts by the power 0.75 of the ratio
    EXPECT_NEAR(body.stiffness()/atRest, 0.5 + 0.5*std::pow(8, 0.375), 0.02);
}


TEST(membraneForces, volumeIsKept)
{
    const auto shape =
        sheetOf("type biconcave; radius 3.91e-6;", "", 0.5e-6);
    EXPECT_NEAR(shape->referenceVolume()/94.1e-18, 1, 0.002);
    const auto group = movedCopies(*shape, 2, 2e-8);
    const scalar dt = 1e-5;
    Eigen::MatrixXd v(Eigen::MatrixXd::Constant(shape->nNodes(), 6, 1e-3));
    dynamic_cast<immersedBodies&>(*group).keepVolume(dt, v);
    group->move(dt, v);
    for (label copyi = 0; copyi < 2; ++copyi)
    {
        EXPECT_NEAR
        (
            group->volume(copyi)/shape->referenceVolume(), 1, 1e-12
        );
    }
}


// ************************************************************************* //
