// SPDX-License-Identifier: GPL-3.0-or-later

#include "deltaKernel.H"
#include "immersedBodies.H"
#include "membraneSlip.H"
#include "samples/samples.H"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const membraneForceStep step{1e-3, 2, 0.05, 17, 0.3};


//- A sphere, or a circle, of the radius 1
std::unique_ptr<shapeTemplate> sheet(const label nDims, const string& others)
{
    const string shape = nDims == 2 ? "circle" : "sphere";
    const bool drop = others.find("drop") != string::npos;
    const string modulus(drop ? "" : "shearModulus 1; ");
    const dictionary dict
    (
        dictionaryOf
        (
            "shape { type " + shape + "; radius 1; } material { type membrane;"
            " density 1; " + modulus + others + " }"
        )
    );
    const meshGrading grading((dictionary()));
    const scalar spacing = 0.1;
    return std::make_unique<shapeTemplate>
    (
        "cell",
        dict,
        newShapeMesh(dict.subDict("shape"), nDims, spacing, grading, false),
        spacing,
        1,
        nDims
    );
}


membraneSlip slipOf(const shapeTemplate& shape)
{
    return membraneSlip(*shape.sheet(), shape.mesh(), shape.nodeSpacing(), 1);
}


//- Positions of a shape, a row per node
Eigen::MatrixXd positionsOf(const shapeTemplate& shape)
{
    Eigen::MatrixXd x(shape.nNodes(), shape.nDims());
    forAll(shape.mesh().points, i)
    {
        for (direction d = 0; d < shape.nDims(); ++d)
        {
            x(i, d) = shape.mesh().points[i][d];
        }
    }
    return x;
}


//- Area of each node
Eigen::ArrayXd areasOf(const shapeTemplate& shape, const Eigen::MatrixXd& x)
{
    Eigen::ArrayXd areas(Eigen::ArrayXd::Zero(x.rows()));
    for (const surfaceFace& f : shape.faces())
    {
        const Eigen::VectorXd a(x.row(f[1]) - x.row(f[0]));
        scalar area = a.norm()/2;
        if (shape.nDims() == 3)
        {
            const Eigen::Vector3d b(x.row(f[2]) - x.row(f[0]));
            area = Eigen::Vector3d(a).cross(b).norm()/6;
        }
        for (direction k = 0; k < shape.nDims(); ++k)
        {
            areas[f[k]] += area;
        }
    }
    return areas;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(membraneSlip, isTheForceAlongTheSheetOverTheViscosity)
{
    for (const label nDims : {2, 3})
    {
        const auto shape = sheet(nDims, "innerViscosity 10;");
        const Eigen::MatrixXd x(positionsOf(*shape));
        const Eigen::ArrayXd areas(areasOf(*shape, x));

        // Turns about z: along the sheet everywhere
        Eigen::MatrixXd turn(Eigen::MatrixXd::Zero(x.rows(), nDims));
        turn.col(0) = -x.col(1);
        turn.col(1) = x.col(0);
        const scalar pressure = 7, density = 4;
        Eigen::MatrixXd force(density*turn + pressure*x);
        force.array().colwise() *= areas;

        const membraneSlip slip(slipOf(*shape));
        Eigen::MatrixXd v(Eigen::MatrixXd::Zero(x.rows(), nDims));
        slip.add(step, 1, x, force, v);
        const scalar perForce = 0.3*0.05*(1.0/2 + 1.0/10)/2;
        const Eigen::MatrixXd exact(perForce*density*turn);
        EXPECT_LT((v - exact).norm(), 0.02*exact.norm());
    }
}


TEST(membraneSlip, smoothsShortWavesAsOftenAsTheStepNeeds)
{
    const auto shape = sheet(2, "");
    const membraneSlip slip(slipOf(*shape));
    const Eigen::MatrixXd x(positionsOf(*shape));
    Eigen::MatrixXd force(x.rows(), 2), v(Eigen::MatrixXd::Zero(x.rows(), 2));
    for (label i = 0; i < x.rows(); ++i)
    {
        const scalar sign = i % 2 ? 1 : -1;
        force.row(i) << -sign*x(i, 1), sign*x(i, 0);
    }
    // The number of nodes may be odd: away from the seam
    slip.add(step, 1, x, force, v);
    const scalar perForce = step.lag*step.spacing/step.viscosity/0.1;
    EXPECT_LT(v.middleRows(2, x.rows() - 4).norm(), 0.02*perForce*force.norm());

    const label few = slip.passes(step, 1);
    const scalar most = 17*step.viscosity*step.spacing/step.dt;
    EXPECT_EQ(few, label(0.736*2*0.3*17*0.25));
    EXPECT_EQ(slip.passes(step, most), few);
    EXPECT_EQ(slip.passes(step, 3*most), label(0.736*2*0.3*51*0.25));
    EXPECT_EQ(slip.passes(step, 1e9*most), 1000);
}


template<int width>
scalar sampledLag()
{
    std::mt19937 generator(1);
    std::normal_distribution<scalar> gauss(0, 1);
    std::uniform_real_distribution<scalar> part(0, 1);
    const auto draw = [&](const scalar place)
    {
        const deltaKernel<width> kernel(place);
        scalar rest = part(generator);
        label i = 0;
        while (i < width - 1 && rest > kernel.weights[i])
        {
            rest -= kernel.weights[i++];
        }
        return kernel.first + i - place;
    };
    const label nSamples = 200000;
    scalar sum = 0;
    for (label sample = 0; sample < nSamples; ++sample)
    {
        const auto anyDirection = [&]()
        {
            return Eigen::Vector3d
            (
                gauss(generator), gauss(generator), gauss(generator)
            ).normalized();
        };
        const Eigen::Vector3d n(anyDirection());
        Eigen::Vector3d along(anyDirection());
        along = (along - along.dot(n)*n).normalized();

        // The velocity along a direction is a mean of two cells' velocities,
        // and a cell has the mean force of two faces along this direction
        scalar rest = part(generator);
        label component = 0;
        while (component < 2 && rest > along[component]*along[component])
        {
            rest -= along[component]*along[component];
            ++component;
        }
        scalar across = 0;
        for (label d = 0; d < 3; ++d)
        {
            across += n[d]
               *(draw(100*part(generator)) - draw(100*part(generator)));
        }
        const scalar means = part(generator);
        across += n[component]*(means < 0.25 ? -1 : means < 0.5 ? 1 : 0);
        sum += std::abs(across);
    }
    return sum/(2*nSamples);
}


TEST(membraneSlip, lagOfTheKernels)
{
    EXPECT_NEAR(sampledLag<2>(), deltaKernel<2>::lag, 0.01);
    EXPECT_NEAR(sampledLag<3>(), deltaKernel<3>::lag, 0.01);
    EXPECT_NEAR(sampledLag<4>(), deltaKernel<4>::lag, 0.01);
}


TEST(membraneForceStep, isShorterAroundALessViscousFluid)
{
    const auto longest = [](const string& inside)
    {
        const auto shape = sheet(2, inside);
        const auto group = groupOf(*shape);
        group->append(point::zero, tensor::I, Zero, Zero, 0);
        return dynamic_cast<immersedBodies&>(*group).longestStep(step);
    };
    const scalar same = longest("");
    EXPECT_EQ(longest("innerViscosity 10;"), same);
    // The harmonic mean with a fifth of the viscosity is a third of it
    EXPECT_NEAR(longest("innerViscosity 0.4;")/same, 1/3.0, 1e-9);
    // A drop has no force along its surface
    const string drop("law drop; tension 1;");
    EXPECT_EQ(longest(drop + "innerViscosity 0.4;"), longest(drop));
}


TEST(membraneForceStep, forcesOfADropAreExplicit)
{
    const auto shape = sheet(3, "law drop; tension 1;");
    const auto group = groupOf(*shape);
    group->append(point::zero, tensor::I, Zero, Zero, 0);
    group->positions().col(0) *= 1.2;
    auto& membranes = dynamic_cast<immersedBodies&>(*group);
    membraneForceStep longest(step);
    longest.dt *= membranes.longestStep(step)/step.dt*(1 - 1e-9);
    EXPECT_NEAR(longest.number(2), longest.mostExplicit, 1e-6);
    Eigen::MatrixXd explicitForce, force;
    group->internalForce(explicitForce);
    membranes.stepForces(longest, force);
    EXPECT_EQ((force - explicitForce).norm(), 0);
    longest.dt *= 1.01;
    EXPECT_THROW(membranes.stepForces(longest, force), Foam::error);
}


// ************************************************************************* //
