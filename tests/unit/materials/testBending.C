// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/energyGradient.H"
#include "samples/membraneSamples.H"
#include "mathematicalConstants.H"
#include "vector2D.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using constant::mathematical::pi;

const scalar Kb = 3e-3;

//- Bending only: stretching is too weak to count
const string straight
(
    "density 1; stretchingModulus 1e-9; bendingModulus 3e-3; "
    "innerViscosity 1; restCurvature 0;"
);


//- Curvature of an ellipse at the parameter t, from (a cos t, b sin t)
scalar curvature(const scalar a, const scalar b, const scalar t)
{
    const scalar speed = std::hypot(a*std::sin(t), b*std::cos(t));
    return a*b/pow3(speed);
}


//- Half the integral of K_b c^2 along an ellipse
scalar bendingEnergy(const scalar a, const scalar b)
{
    const label n = 2000;
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar t = 2*pi*i/n;
        const scalar speed = std::hypot(a*std::sin(t), b*std::cos(t));
        sum += 0.5*Kb*sqr(curvature(a, b, t))*speed*2*pi/n;
    }
    return sum;
}


//- Force per length of a membrane with the moment K_b c and no tension, along
//  the outward normal and the tangent: K_b (c'', c c'), primes along it
vector2D bendingForce(const scalar a, const scalar b, const scalar t)
{
    const scalar e = 1e-3;
    const auto speed = [&](const scalar s)
    {
        return std::hypot(a*std::sin(s), b*std::cos(s));
    };
    const auto slope = [&](const scalar s)
    {
        return (curvature(a, b, s + e) - curvature(a, b, s - e))/(2*e*speed(s));
    };
    const scalar second = (slope(t + e) - slope(t - e))/(2*e*speed(t));
    return Kb*vector2D(second, curvature(a, b, t)*slope(t));
}


//- Put the boundary nodes onto an ellipse at equal distances along it. (Those
//  of a shape lie on chords of its outline, a millionth of the size off, which
//  a fourth derivative shows.)
void placeOnEllipse(bodyGroup& group, const scalar a, const scalar b)
{
    const label nFine = 100000, n = group.shape().nBoundaryNodes();
    scalarField arc(nFine + 1, Zero);
    for (label i = 0; i < nFine; ++i)
    {
        const scalar t = 2*pi*(i + 0.5)/nFine;
        arc[i + 1] = arc[i]
          + std::hypot(a*std::sin(t), b*std::cos(t))*2*pi/nFine;
    }
    label fine = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar wanted = arc.last()*i/n;
        while (arc[fine + 1] < wanted)
        {
            ++fine;
        }
        const scalar part = (wanted - arc[fine])/(arc[fine + 1] - arc[fine]);
        const scalar t = 2*pi*(fine + part)/nFine;
        group.positions()(i, 0) = a*std::cos(t);
        group.positions()(i, 1) = b*std::sin(t);
    }
}


//- Largest error of the nodal forces on an ellipse, over the largest pressure
scalar forceError(const scalar a, const scalar b, const scalar spacing)
{
    auto shape = membraneOf(name(a) + " " + name(b), straight, spacing);
    auto group = cellOf(*shape);
    placeOnEllipse(*group, a, b);
    const Eigen::MatrixXd& x = group->positions();
    Eigen::MatrixXd force;
    group->internalForce(force);

    scalar worst = 0, largest = 0;
    const label n = shape->nBoundaryNodes();
    for (label i = 0; i < n; ++i)
    {
        const scalar length = 0.5
           *(
                (x.row((i + 1) % n) - x.row(i)).norm()
              + (x.row((i + n - 1) % n) - x.row(i)).norm()
            );
        const scalar t = std::atan2(x(i, 1)/b, x(i, 0)/a);
        vector normal(x(i, 0)/sqr(a), x(i, 1)/sqr(b), 0);
        normal /= mag(normal);
        const vector2D expected(bendingForce(a, b, t));
        const vector2D found
        (
            (normal.x()*force(i, 0) + normal.y()*force(i, 1))/length,
            (normal.x()*force(i, 1) - normal.y()*force(i, 0))/length
        );
        worst = max(worst, mag(found - expected));
        largest = max(largest, mag(expected));
    }
    return worst/largest;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(bending, energyOfCircleAndEllipseConverges)
{
    for (const scalar b : {0.1, 0.05})
    {
        const scalar exact = bendingEnergy(0.1, b);
        scalar error = GREAT;
        for (const scalar spacing : {0.02, 0.01, 0.005})
        {
            auto shape = membraneOf("0.1 " + name(b), straight, spacing);
            const scalar energy = cellOf(*shape)->elasticEnergy();
            EXPECT_LT(mag(energy/exact - 1), error/3) << b << " " << spacing;
            error = mag(energy/exact - 1);
        }
        // Turns between chords of a length s on a radius r: (s/r)^2/12
        EXPECT_LT(error, sqr(0.005*0.1/sqr(b))/12);
    }
    EXPECT_NEAR(bendingEnergy(0.1, 0.1), pi*Kb/0.1, 1e-12);
}


TEST(bending, forceOfAnEllipseConverges)
{
    const scalar coarse = forceError(0.1, 0.07, 0.01);
    const scalar fine = forceError(0.1, 0.07, 0.005);
    EXPECT_LT(fine, coarse/3);
    EXPECT_LT(fine, 0.02);
}


TEST(bending, forceIsTheGradientOfTheEnergy)
{
    auto shape = membraneOf("0.1 0.06", typical + "restCurvature 3;");
    auto group = cellOf(*shape);
    crumple(*group, 2e-3);
    expectGradientOfEnergy(*group, shape->nBoundaryNodes(), 1e-6);
}


TEST(bending, restsInItsOutlineAndHasNoForceOnTheWhole)
{
    auto rest = membraneOf("0.1 0.05", typical);
    Eigen::MatrixXd force;
    cellOf(*rest)->internalForce(force);
    EXPECT_EQ(force.norm(), 0);

    auto shape = membraneOf("0.1 0.05", straight);
    auto group = cellOf(*shape);
    group->internalForce(force);
    const Eigen::MatrixXd& x = group->positions();
    EXPECT_LT(force.colwise().sum().norm(), 1e-13*force.norm());
    EXPECT_NEAR
    (
        x.col(0).dot(force.col(1)) - x.col(1).dot(force.col(0)),
        0,
        1e-14*force.norm()
    );
}


// ************************************************************************* //
