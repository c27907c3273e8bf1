// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementViscosity.H"
#include "samples/energyGradient.H"
#include "samples/newShapeTemplate.H"

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 3e3, radius = 0.06, thickness = 0.1;

const string neoHookean("type neoHookean; density 1000; E 3e3; ");
const string springs("density 1000; E 3e3; ");
const string exact("iterations 1000; tolerance 1e-8;");


//- A red cell's section with nodes so many to its width
std::unique_ptr<shapeTemplate> redCell
(
    const string& material,
    const scalar nodesPerWidth,
    const string& admm = exact
)
{
    return newShapeTemplate
    (
        "cell",
        dictionaryOf
        (
            "shape { type biconcave; radius " + Foam::name(radius)
          + "; } material { " + material + " } admm { " + admm + " }"
        ),
        2*radius/nodesPerWidth,
        thickness,
        2
    );
}


//- Force that bends it: upwards at both ends, downwards in the middle
Eigen::MatrixXd bendingForce(const shapeTemplate& shape)
{
    scalar length = 0, squares = 0;
    for (const surfaceFace& face : shape.faces())
    {
        const point& a = shape.points()[face[0]];
        const point& b = shape.points()[face[1]];
        length += mag(b - a);
        squares += mag(b - a)*sqr(0.5*(a.x() + b.x()));
    }
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(shape.nNodes(), 2);
    for (const surfaceFace& face : shape.faces())
    {
        const point& a = shape.points()[face[0]];
        const point& b = shape.points()[face[1]];
        const scalar f = 1e-3*E*thickness*mag(b - a)/sqr(radius)
           *(sqr(0.5*(a.x() + b.x())) - squares/length);
        force(face[0], 1) += 0.5*f;
        force(face[1], 1) += 0.5*f;
    }
    return force;
}


//- Work of that force on the way to equilibrium, times two [J]
scalar bending(const string& material, const scalar nodesPerWidth)
{
    const auto shape = redCell(material, nodesPerWidth);
    const auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    const Eigen::MatrixXd force = bendingForce(*shape);

    // Mass does not count in a step of a hundred times its waves
    const scalar dt = 100*radius/std::sqrt(E/1000);
    Eigen::MatrixXd v;
    group->predict(0, dt, force, v);
    return dt*(force.array()*v.array()).sum();
}


//- A body whose nodes are where a matrix takes them
std::unique_ptr<bodyGroup> affine
(
    const shapeTemplate& shape,
    const Eigen::Matrix2d& F
)
{
    auto group = groupOf(shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    group->positions() = (group->positions()*F.transpose()).eval();
    return group;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(strain, uniformStrainIsTheSameInAllDomains)
{
    Eigen::Matrix2d F, L;
    F << 1.3, 0.4, -0.2, 0.8;
    L << 2, -1, 0.5, 3;
    for (const string& type : {springs, neoHookean})
    {
        // Constants of springs are found with the area term: they differ
        const string material
        (
            type + (type == springs ? "calibration vanGelder; " : "")
          + "viscosity 5; "
        );
        const auto one = redCell(material + "strain triangle;", 20);
        const auto other = redCell(material + "strain smoothed;", 20);
        const auto a = affine(*one, F), b = affine(*other, F);
        EXPECT_NEAR
        (
            a->elasticEnergy(), b->elasticEnergy(), 1e-12*a->elasticEnergy()
        );

        Eigen::MatrixXd force, otherForce;
        a->internalForce(force);
        b->internalForce(otherForce);
        EXPECT_LT((force - otherForce).norm(), 1e-11*force.norm());

        const Eigen::MatrixXd v = a->positions()*L.transpose();
        for (bodyGroup* group : {a.get(), b.get()})
        {
            Eigen::MatrixXd& f = group == a.get() ? force : otherForce;
            f.setZero();
            elementViscosity::addForce
            (
                group->shape(), group->positions(), v, labelRange(0, 1), f
            );
        }
        EXPECT_GT(force.norm(), 0);
        EXPECT_LT((force - otherForce).norm(), 1e-11*force.norm());
    }
}


TEST(strain, smoothedForceIsTheGradientOfTheEnergy)
{
    for (const string& type : {springs, neoHookean})
    {
        const auto shape = redCell(type + "strain smoothed;", 12);
        const auto group = groupOf(*shape);
        group->append(Zero, tensor::I, Zero, Zero, 0);
        crumple(*group, 1e-3);
        expectGradientOfEnergy(*group, shape->nNodes(), 1e-5);
    }
}


// The step of implicit Euler, (3.9), balances inertia, load and that force

TEST(strain, theSolverHasTheSameForce)
{
    const scalar dt = 0.5*radius/std::sqrt(E/1000);
    for (const string scheme : {"quasiNewton", "ADMM"})
    {
        for (const string& type : {springs, neoHookean})
        {
            const auto shape = redCell
            (
                type + "strain smoothed;",
                16,
                "scheme " + scheme
              + "; rotation implicitEuler; iterations 3000; tolerance 1e-11;"
            );
            const auto group = groupOf(*shape);
            group->append(Zero, tensor::I, Zero, Zero, 0);
            const Eigen::MatrixXd load = 20*bendingForce(*shape);
            Eigen::MatrixXd v, force;
            group->predict(0, dt, load, v);
            group->positions() += dt*v;
            group->internalForce(force);
            const Eigen::Map<const Eigen::VectorXd> masses
            (
                shape->nodeMasses().cdata(), shape->nNodes()
            );
            const Eigen::MatrixXd residual =
                masses.asDiagonal()*v/dt - force - load;
            EXPECT_LT(residual.norm(), 1e-4*load.norm())
                << scheme << " " << type;
            EXPECT_GT(force.norm(), 0.1*load.norm());
        }
    }
}


// Where the cell is thinnest it is a tenth as thick as wide: one row of
// triangles with 12 nodes to the width. The reference is the same cell with 48

TEST(strain, thinBodiesBend)
{
    const scalar reference = bending(neoHookean + "strain smoothed;", 48);
    const scalar smoothed = bending(neoHookean + "strain smoothed;", 12);
    const scalar triangle = bending(neoHookean + "strain triangle;", 12);
    const scalar fine = bending(neoHookean + "strain triangle;", 48);
    EXPECT_NEAR(fine, reference, 0.2*reference);
    EXPECT_NEAR(smoothed, reference, 0.3*reference);
    EXPECT_LT(triangle, 0.4*reference);
}


// ************************************************************************* //
