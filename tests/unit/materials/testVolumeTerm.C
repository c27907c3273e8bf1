// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    The area term of one element: its gradient, and ADMM's local step.

\*---------------------------------------------------------------------------*/

#include "laneArray.H"
#include "volumeTerm.H"

#include <Eigen/Dense>
#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

typedef laneArray<1> array;
typedef Eigen::Matrix2d matrix;

//- Apply a function of the entries, row by row, to a matrix
template<class Function>
matrix applied(const matrix& F, Function&& f)
{
    array entries[4];
    for (int i = 0; i < 4; ++i)
    {
        entries[i] = F(i/2, i % 2);
    }
    f(entries);
    matrix result;
    for (int i = 0; i < 4; ++i)
    {
        result(i/2, i % 2) = entries[i][0];
    }
    return result;
}


matrix gradient(const matrix& F)
{
    return applied
    (
        F,
        [](array* entries) { volumeTerm::toGradient<2>(entries, 0); }
    );
}


matrix localStep(const matrix& y, const scalar ratio)
{
    return applied
    (
        y,
        [ratio](array* u)
        {
            const array none[4] = {0, 0, 0, 0};
            volumeTerm::toLocalStep<2>(none, u, ratio, 0);
        }
    );
}


//- Stretch by s and 1/s with the area changed by the factor area, turned
matrix stretched(const scalar s, const scalar area, const scalar angle)
{
    const Eigen::Rotation2D<double> before(angle), after(1.7*angle + 0.3);
    return
        after.toRotationMatrix()
       *Eigen::Vector2d(s*area, 1/s).asDiagonal()
       *before.toRotationMatrix();
}


TEST(volumeTerm, gradientIsThatOfTheEnergy)
{
    const auto energy = [](const matrix& F)
    {
        return 0.25*sqr(F.determinant() - 1);
    };
    const matrix F(stretched(1.7, 0.6, 0.4));
    const matrix g(gradient(F));
    const scalar step = 1e-6;
    for (int i = 0; i < 4; ++i)
    {
        matrix up(F), down(F);
        up(i/2, i % 2) += step;
        down(i/2, i % 2) -= step;
        EXPECT_NEAR
        (
            g(i/2, i % 2), (energy(up) - energy(down))/(2*step), 1e-9
        );
    }
}


TEST(volumeTerm, nothingHappensAtRest)
{
    EXPECT_EQ(gradient(matrix::Identity()).norm(), 0);
    EXPECT_EQ(localStep(matrix::Identity(), 0.5).norm(), 0);
}


TEST(volumeTerm, localStepIsTheMinimum)
{
    // dV/dz + w^2 (z - y) = 0, over kappa; areas before the step
    for (const scalar ratio : {0.5, 1.0, 2.0})
    {
        for (const scalar s : {1.0, 1.5, 3.0})
        {
            for (const scalar area : {0.5, 0.999, 1.5})
            {
                const matrix y(stretched(s, area, 0.9));
                const matrix away(localStep(y, ratio));
                const matrix left(gradient(y - away) - ratio*away);
                EXPECT_LT(left.norm(), 1e-6)
                    << "ratio " << ratio << ", s " << s << ", area " << area;
            }
        }
    }
}


TEST(volumeTerm, anInvertedElementIsDrivenBack)
{
    matrix y(matrix::Identity());
    y(1, 1) = -0.5;
    const matrix z(y - localStep(y, 0.5));
    EXPECT_GT(z.determinant(), y.determinant());
    EXPECT_GT(z(1, 1), y(1, 1));
    EXPECT_TRUE(std::isfinite(z.norm()));
}


TEST(volumeTerm, stretchedElementsKeepTheirStiffness)
{
    // The force along a stretch of s for a change of area is that of the
    // unstretched element times the length on which it acts
    const scalar area = 0.99;
    const scalar atRest = gradient(stretched(1, area, 0)).norm();
    const scalar s = 3;
    const scalar expected = std::sqrt((sqr(s*area) + 1/sqr(s))/(1 + sqr(area)));
    EXPECT_NEAR(gradient(stretched(s, area, 0)).norm()/atRest, expected, 1e-12);
}

} // End namespace

// ************************************************************************* //
