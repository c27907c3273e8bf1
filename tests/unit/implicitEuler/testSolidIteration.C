// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    How fast the iterations of implicit Euler converge in 3D, and what eight of
    them do to the energy.

\*---------------------------------------------------------------------------*/

#include "samples/solidSamples.H"

#include <gtest/gtest.h>

using namespace solidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4, rho = 1000, side = 0.1;
const string neoHookean("density 1000; E 1e4; ");
const string springs
(
    "type elastic; density 1000; E 1e4; calibration vanGelder; "
);


//- Time step in which waves go so many spacings
scalar stepOf(const scalar reach)
{
    return reach*side/std::sqrt(E/rho);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solidIteration, eightIterationsAreMoreExactThanTenOfAdmm)
{
    for (const scalar reach : {0.2, 0.7, 3.0})
    {
        const auto after = [&](const string& admm)
        {
            const auto shape =
                solidOf(unevenCentredCube(4, side), side, springs, admm);
            copies body(*shape);
            body.deform(Eigen::Vector3d(1.1, 0.97, 0.94).asDiagonal());
            return body.predicted(stepOf(reach), unevenForce(body, 5));
        };
        const Eigen::MatrixXd exact =
            after("iterations 9000; tolerance 1e-13;");
        const scalar admm = (after("scheme ADMM;") - exact).norm();
        const scalar found = (after("") - exact).norm();
        EXPECT_LT(found, admm) << reach;
        EXPECT_GT(found, 0);
    }
}


// From three times its length a body that is let go contracts by most of that
// in one step of three spacings: the eighth iteration is not yet near the end

TEST(solidIteration, stretchedBodiesConverge)
{
    for (const scalar stretch : {1.5, 2.0, 3.0})
    {
        for (const scalar reach : {0.2, 0.7, 3.0})
        {
            const auto after = [&](const string& admm)
            {
                const auto shape =
                    solidOf(unevenCentredCube(4, side), side, neoHookean, admm);
                copies body(*shape);
                const scalar thin = 1/std::sqrt(stretch);
                body.deform(Eigen::Vector3d(stretch, thin, thin).asDiagonal());
                return body.predicted(stepOf(reach), unevenForce(body, 5));
            };
            const Eigen::MatrixXd exact =
                after("iterations 9000; tolerance 1e-12;");
            const scalar first = (after("iterations 1;") - exact).norm();
            if (stretch*reach < 9)
            {
                EXPECT_LT((after("") - exact).norm(), 0.3*first)
                    << stretch << ", " << reach;
            }
            EXPECT_LT((after("iterations 60;") - exact).norm(), 0.03*first)
                << stretch << ", " << reach;
        }
    }
}


// Let go after a stretch; implicit Euler loses energy in each step

TEST(solidIteration, energyOfAnOscillatingBodyNeverRises)
{
    for (const string& material : {neoHookean, springs})
    {
        for (const scalar reach : {0.2, 1.0})
        {
            const auto shape =
                solidOf(unevenCentredCube(4, side), side, material);
            copies body(*shape);
            body.deform(Eigen::Vector3d(1.2, 0.95, 0.88).asDiagonal());
            scalar last = body.energy();
            const scalar start = last;
            scalar leastElastic = start;
            for (label step = 0; step < 60; ++step)
            {
                body.run(body.none(), stepOf(reach), 1);
                const scalar elastic = body.energy();
                const scalar now = elastic + body.kineticEnergy();
                EXPECT_LT(now, last + 1e-10*start) << material << reach;
                last = now;
                leastElastic = min(leastElastic, elastic);
            }
            // It did oscillate
            EXPECT_LT(leastElastic, 0.3*start);
        }
    }
}


// ************************************************************************* //
