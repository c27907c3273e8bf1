// SPDX-License-Identifier: GPL-3.0-or-later

#include "copyValues.H"
#include "membraneViscosity.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar viscosity = 3e-7, modulus = 3e-3;

const string material
(
    "type membrane; density 1000; shearModulus 5e-6; membraneViscosity 3e-7;"
    " viscousModulus 3e-3;"
);


std::unique_ptr<shapeTemplate> sheetOf(const string& materialText)
{
    const scalar spacing = 0.5e-6;
    const dictionary dict
    (
        dictionaryOf
        (
            "shape { type biconcave; radius 3.91e-6; } material { "
          + materialText + " }"
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


//- Positions of the shape's nodes, a row per node
Eigen::MatrixXd atRest(const shapeTemplate& shape)
{
    Eigen::MatrixXd x(shape.points().size(), 3);
    forAll(shape.points(), i)
    {
        const point& p = shape.points()[i];
        x.row(i) << p.x(), p.y(), p.z();
    }
    return x;
}


//- Power that 2 mu_m dev(D):D takes in all triangles, if nodes move with
//  v = G x. D is the rate of strain in the plane
scalar power
(
    const shapeTemplate& shape,
    const Eigen::MatrixXd& x,
    const Eigen::Matrix3d& G
)
{
    scalar sum = 0;
    for (const surfaceFace& f : shape.mesh().faces)
    {
        const Eigen::Vector3d a(x.row(f[1]) - x.row(f[0]));
        const Eigen::Vector3d b(x.row(f[2]) - x.row(f[0]));
        Eigen::Matrix<scalar, 3, 2> plane;
        plane.col(0) = a.normalized();
        plane.col(1) =
            (b - b.dot(plane.col(0))*plane.col(0)).normalized();
        const Eigen::Matrix2d inPlane(plane.transpose()*G*plane);
        const Eigen::Matrix2d D(0.5*(inPlane + inPlane.transpose()));
        const Eigen::Matrix2d dev
        (
            D - 0.5*D.trace()*Eigen::Matrix2d::Identity()
        );
        sum += 0.5*a.cross(b).norm()*2*viscosity*dev.squaredNorm();
    }
    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(membraneViscosity, steadyStrainTakesThePowerOfTheViscosity)
{
    const auto shape = sheetOf(material);
    membraneViscosity sheet(*shape->sheet(), shape->mesh());
    sheet.resize(1);
    sheet.start(0);
    Eigen::Matrix3d G;
    G << 1, 2, 0.3, -1, 0.5, 0.7, 0.2, -0.4, -1.5;

    // 20 relaxation times, in which nodes move by a thousandth of their places
    const scalar time = viscosity/modulus;
    const scalar dt = 0.1*time;
    G *= 1e-3/(20*time);
    Eigen::MatrixXd x(atRest(*shape));
    for (label step = 0; step < 200; ++step)
    {
        x += dt*x*G.transpose();
        sheet.relax(dt, x);
    }
    Eigen::MatrixXd force(Eigen::MatrixXd::Zero(x.rows(), 3));
    sheet.addForce(x, force);
    const Eigen::MatrixXd v(x*G.transpose());
    const scalar taken = -force.cwiseProduct(v).sum();
    const scalar expected = power(*shape, x, G);
    EXPECT_NEAR(taken, expected, 2e-3*expected);

    // Neither a force nor a torque on the whole
    const scalar scale = force.cwiseAbs().sum();
    EXPECT_LT(force.colwise().sum().norm(), 1e-12*scale);
    Eigen::RowVector3d torque(Eigen::RowVector3d::Zero());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
    {
        const Eigen::RowVector3d arm(x.row(i)), f(force.row(i));
        torque += arm.cross(f);
    }
    EXPECT_LT(torque.norm(), 1e-12*scale*4e-6);
}


TEST(membraneViscosity, turningMakesNoForce)
{
    const auto shape = sheetOf(material);
    membraneViscosity sheet(*shape->sheet(), shape->mesh());
    sheet.resize(1);
    sheet.start(0);
    const Eigen::AngleAxisd turn(0.3, Eigen::Vector3d(1, 2, 3).normalized());
    const Eigen::MatrixXd x
    (
        atRest(*shape)*turn.toRotationMatrix().transpose()
    );
    sheet.relax(1e-6, x);
    Eigen::MatrixXd force(Eigen::MatrixXd::Zero(x.rows(), 3));
    sheet.addForce(x, force);
    EXPECT_LT(force.cwiseAbs().maxCoeff(), 1e-12*modulus*4e-6);
}


TEST(membraneViscosity, stateGoesWithACopy)
{
    const auto shape = sheetOf(material);
    const std::unique_ptr<bodyGroup> group(groupOf(*shape));
    group->append(point(0, 0, 0), tensor::I, Zero, Zero, 0);
    Eigen::MatrixXd v(10*group->positions());
    v.col(0) *= -1;
    group->move(1e-3, v);
    Eigen::MatrixXd force, other;
    group->internalForce(force);

    copyValues taken;
    group->take(0, taken);
    const std::unique_ptr<bodyGroup> next(groupOf(*shape));
    next->append(point(0, 0, 0), tensor::I, Zero, Zero, 1);
    copyValues given(taken.values());
    next->exchange(0, given);
    next->internalForce(other);
    EXPECT_EQ(force, other);

    // Values that no triangle can have
    membraneViscosity sheet(*shape->sheet(), shape->mesh());
    sheet.resize(1);
    sheet.start(0);
    EXPECT_TRUE(sheet.sound());
    sheet.natural()(1, 0) = 2*sheet.natural()(0, 0) + 2*sheet.natural()(2, 0);
    EXPECT_FALSE(sheet.sound());

    // Without viscosity the force is another one
    const auto elastic =
        sheetOf("type membrane; density 1000; shearModulus 5e-6;");
    const std::unique_ptr<bodyGroup> without(groupOf(*elastic));
    without->append(point(0, 0, 0), tensor::I, Zero, Zero, 0);
    without->move(1e-3, v);
    without->internalForce(other);
    EXPECT_GT((force - other).norm(), 0.1*other.norm());
}


TEST(membraneViscosity, aViscosityNeedsItsModulus)
{
    EXPECT_THROW
    (
        sheetOf
        (
            "type membrane; density 1000; shearModulus 5e-6;"
            " membraneViscosity 3e-7;"
        ),
        Foam::IOerror
    );
}


// ************************************************************************* //
