// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const string rubber("density 1000; E 1e4;");
const string scheme("scheme quasiNewton; ");


//- One step of a disc stretched to (x, y) times its size and left alone
Eigen::MatrixXd letGo
(
    const string& admm,
    const scalar dt,
    const scalar x,
    const scalar y,
    scalar& change
)
{
    const auto shape = disc(rubber, admm);
    const auto group = groupOf(*shape);
    group->append(Zero, tensor::I, vector(0.3, 0.1, 0), vector(0, 0, 4), 0);
    group->positions().col(0) *= x;
    group->positions().col(1) *= y;
    admmSolver solver(*shape);
    Eigen::MatrixXd v;
    const Eigen::MatrixXd force = unevenForce(*group, 5);
    solver.solve
    (
        dt,
        {group->positions(), group->velocities(), force, {}},
        v
    );
    change = solver.lastChange();
    return v;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(quasiNewton, eightIterationsAreMoreExactThanTenOfAdmm)
{
    // Steps in which waves go 0.3, 1 and 3 node spacings
    for (const scalar dt : {2e-3, 6.3e-3, 1.9e-2})
    {
        scalar change;
        const string tight(scheme + "iterations 3000; tolerance 1e-13;");
        const Eigen::MatrixXd exact = letGo(tight, dt, 1.1, 0.93, change);
        EXPECT_LT(change, 1e-13);
        const scalar admm =
            (letGo("scheme ADMM;", dt, 1.1, 0.93, change) - exact).norm();
        const scalar found =
            (letGo(scheme, dt, 1.1, 0.93, change) - exact).norm();
        EXPECT_LT(found, admm) << "dt = " << dt;
        EXPECT_GT(found, 0);
    }
}


TEST(quasiNewton, stretchedBodiesConverge)
{
    // The area term is stiffer by the square of the stretch than A knows
    for (const scalar stretch : {1.5, 2.0, 3.0, 4.0})
    {
        for (const scalar dt : {2e-3, 6.3e-3, 1.9e-2})
        {
            scalar change;
            const auto after = [&](const string& admm)
            {
                return letGo(admm, dt, stretch, 1/stretch, change);
            };
            const Eigen::MatrixXd exact =
                after(scheme + "iterations 9000; tolerance 1e-12;");
            EXPECT_LT(change, 1e-12);
            const auto error = [&](const string& admm)
            {
                return (after(admm) - exact).norm();
            };
            const scalar first = error(scheme + "iterations 1;");
            EXPECT_LT(error(scheme), 0.3*first) << stretch << ", dt = " << dt;
            EXPECT_LT(error(scheme + "iterations 60;"), 0.03*first)
                << stretch << ", dt = " << dt;
        }
    }
}


// ************************************************************************* //
