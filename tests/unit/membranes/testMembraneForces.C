// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "implicitMembraneForces.H"
#include "membraneForces.H"
#include "samples/samples.H"
#include "mathematicalConstants.H"

#include <Eigen/Geometry>
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


//- Size of the torque of forces on nodes
scalar torqueOf(const Eigen::MatrixXd& x, const Eigen::MatrixXd& force)
{
    Eigen::RowVector3d sum(Eigen::RowVector3d::Zero());
    for (Eigen::Index node = 0; node < x.rows(); ++node)
    {
        const Eigen::RowVector3d at(x.row(node)), f(force.row(node));
        sum += at.cross(f);
    }
    return sum.norm();
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
    EXPECT_NEAR(body.stiffness(0)/atRest, 1, 1e-6);
    group->positions().col(0) *= 2;
    group->positions().rightCols(2) *= std::sqrt(0.5);
    // K = 3 G_s counts by the power 0.75 of the ratio
    EXPECT_NEAR(body.stiffness(0)/atRest, 0.5 + 0.5*std::pow(8, 0.375), 0.02);
}


TEST(membraneForces, volumeIsKept)
{
    const auto shape = sheetOf("type biconcave; radius 3.91e-6;", "", 0.5e-6);
    EXPECT_NEAR(shape->referenceVolume()/94.1e-18, 1, 0.002);
    // Changes of more and of less than 1e-5 of the volume
    for (const scalar moved : {2e-8, 1e-11})
    {
        const auto group = movedCopies(*shape, 2, moved);
        const scalar dt = 1e-5;
        Eigen::MatrixXd v(Eigen::MatrixXd::Constant(shape->nNodes(), 6, 1e-3));
        Eigen::MatrixXd free(Eigen::MatrixXd::Ones(v.rows(), v.cols()));
        free.topRows(100).setZero();
        dynamic_cast<immersedBodies&>(*group).keepVolume(dt, free, v);
        EXPECT_TRUE((v.topRows(100).array() == 1e-3).all());
        group->move(dt, v);
        for (label i = 0; i < 2; ++i)
        {
            EXPECT_NEAR(group->volume(i)/shape->referenceVolume(), 1, 1e-12);
        }
    }
}


TEST(membraneForces, implicitOnesFollowTheStiffness)
{
    // Ten copies blown up by 2 %: the tension is that of the area, and the
    // stiffness that leaves out a part of the geometric one is nearly exact.
    // Of the copies every third one is made implicit
    const auto shape = sheetOf
    (
        "type sphere; radius 2e-6;", "areaModulus 5e-3;", 0.5e-6
    );
    const auto group = movedCopies(*shape, 10, 0);
    Eigen::MatrixXd& x = group->positions();
    for (label i = 0; i < x.cols(); ++i)
    {
        const scalar centre = x.col(i).mean();
        x.col(i).array() += 0.02*(x.col(i).array() - centre);
    }
    const membraneForces forces(*shape->sheet(), shape->mesh(), 0.5e-6);
    implicitMembraneForces implicit(forces);
    const labelList copies({0, 3, 6, 9});

    // Forces before are those of nodes that were elsewhere
    const auto moved = movedCopies(*shape, 10, 0.01*0.5e-6);
    const auto atRest = movedCopies(*shape, 10, 0);
    Eigen::MatrixXd f, last, beside;
    forces.energy(x, &f);
    forces.energy(x + moved->positions() - atRest->positions(), &last);
    for (const scalar number : {0.0, 10.0})
    {
        const scalar softness = number/5e-3;
        Eigen::MatrixXd found(last);
        implicit.correct(copies, softness, x, x, found);
        const Eigen::MatrixXd change(found - last);
        const scalar small = 1e-4*0.5e-6/change.cwiseAbs().maxCoeff();
        forces.energy(x + small*change, &beside);
        const Eigen::MatrixXd residual
        (
            f - last - change - softness/small*(f - beside)
        );
        for (label i = 0; i < 10; ++i)
        {
            const auto ofCopy = [&](const Eigen::MatrixXd& values)
            {
                return values.middleCols(3*i, 3).norm();
            };
            if (i % 3)
            {
                EXPECT_EQ(ofCopy(change), 0);
                continue;
            }
            const scalar whole = ofCopy(f - last);
            EXPECT_LT(ofCopy(residual), (number > 0 ? 0.05 : 0.01)*whole);
            EXPECT_GT(ofCopy(change), (number > 0 ? 0.01 : 0.99)*whole);
            const scalar torque =
                torqueOf(x.middleCols(3*i, 3), found.middleCols(3*i, 3));
            EXPECT_LT(torque, 1e-9*2e-6*ofCopy(found));
        }
    }
}


TEST(membraneForces, onlyStiffCopiesAreImplicit)
{
    // One copy of two is stretched so that its modulus counts more
    const auto shape = sheetOf
    (
        "type sphere; radius 2e-6;", "areaModulus 5e-4;", 0.5e-6
    );
    const auto group = movedCopies(*shape, 2, 0);
    group->positions().col(3) *= 1.2;
    auto& membranes = dynamic_cast<immersedBodies&>(*group);
    const scalar resistance = 0.6e-9;

    // A step in which the modulus at rest counts 30
    const scalar dt =
        30*resistance/shape->sheet()->stiffness(shape->nodeSpacing(), 1);
    const membraneForceStep step{dt, resistance/0.5e-6, 0.5e-6, 34, 0};
    Eigen::MatrixXd explicitForce, force;
    group->internalForce(explicitForce);
    membranes.stepForces(step, force);
    const Eigen::MatrixXd change(force - explicitForce);
    EXPECT_EQ(change.leftCols(3).norm(), 0);
    EXPECT_GT(change.rightCols(3).norm(), 0.1*explicitForce.norm());
    const scalar longest = membranes.longestStep(step);
    EXPECT_GT(longest, dt);
    EXPECT_LT(longest, 100.0/30*dt);
    const membraneForceStep tooLong
    {
        1.01*longest, step.viscosity, step.spacing, step.mostExplicit,
        step.lag
    };
    EXPECT_THROW(membranes.stepForces(tooLong, force), Foam::error);
}


// ************************************************************************* //
