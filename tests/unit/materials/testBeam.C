// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/equilibrium.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4;

const string noArea
(
    "density 1; E 1e4; areaStiffness 0; calibration vanGelder;"
);


//- Deflection over L of a cantilever under the end load alpha E I/L^2. A beam
//  twice as long with P at each end and 2 P against it in the middle is two
//  cantilevers. nColumns must be even, for symmetry.
scalar deflection
(
    const scalar alpha,
    const label nColumns,
    const label nRows,
    const string& area
)
{
    const scalar a = 1;
    auto shape = bodyOf
    (
        latticeBar(nColumns, nRows, a), a, "density 1; E 1e4; " + area
    );

    // Nodes of the two ends and of the middle, and L between them
    const scalar half = 0.5*(nColumns + 0.5)*a;
    labelList ends, middle;
    scalar L = 0;
    forAll(shape->points(), i)
    {
        const scalar x = mag(shape->points()[i].x() - half);
        if (x > half - 0.75*a)
        {
            ends.append(i);
            L += x;
        }
        else if (x < 0.75*a)
        {
            middle.append(i);
        }
    }
    L /= ends.size();

    const scalar height = 0.5*std::sqrt(3.0)*a*nRows;
    const scalar P = alpha*E*pow3(height)/12/sqr(L);
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(shape->nNodes(), 2);
    for (const label i : ends)
    {
        force(i, 1) = 2*P/ends.size();
    }
    for (const label i : middle)
    {
        force(i, 1) = -2*P/middle.size();
    }
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    equilibrate(*group, force, 5);

    scalar result = 0;
    const auto y = group->positions().col(1);
    for (const label i : ends)
    {
        result += (y[i] - shape->points()[i].y())/ends.size()/L;
    }
    for (const label i : middle)
    {
        result -= (y[i] - shape->points()[i].y())/middle.size()/L;
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

// Bisshopp and Drucker's large deflections of a cantilever. Triangles of
// constant strain are too stiff in bending, by a part that falls with the
// square of the number of rows: at six rows 4 %, with the default area term
// 15 %
// (locking).

TEST(beam, cantileverBendsAsTheElastica)
{
    // L/H = 20
    const string area("areaStiffness 0;");
    EXPECT_NEAR(deflection(1, 278, 8, area), 0.30172, 0.03*0.30172);
    EXPECT_NEAR(deflection(3, 278, 8, area), 0.60325, 0.03*0.60325);
}


TEST(beam, cantileverWithAreaTermConverges)
{
    // L/H = 10
    const scalar exact = 0.30172;
    const scalar coarse = 1 - deflection(1, 104, 6, "")/exact;
    const scalar fine = 1 - deflection(1, 208, 12, "")/exact;
    EXPECT_LT(mag(fine), 0.05);
    EXPECT_LT(mag(fine), 0.4*mag(coarse));
}


TEST(beam, planeWaveHasTheFrequencyOfTheLattice)
{
    // Longitudinal wave along a row: m omega^2 = k (4 sin^2(q a/2)
    // + 2 sin^2(q a/4)), from the forces on a node inside
    const scalar a = 0.1;
    auto shape = bodyOf(latticeBar(20, 10, a), a, noArea);
    auto group = groupOf(*shape);
    const scalar k = max(shape->springConstants());

    const label node = shape->nNodes() - 1 - 60;
    ASSERT_GE(node, shape->nBoundaryNodes());
    const scalar x0 = shape->points()[node].x();
    for (const scalar qa : {0.1, 1.0, 3.0})
    {
        auto wave = groupOf(*shape);
        wave->append(Zero, tensor::I, Zero, Zero, 0);
        const scalar amplitude = 1e-6*a;
        forAll(shape->points(), i)
        {
            wave->positions()(i, 0) +=
                amplitude*std::cos(qa*(shape->points()[i].x() - x0)/a);
        }
        Eigen::MatrixXd force;
        wave->internalForce(force);
        const scalar expected =
            k*(4*sqr(std::sin(0.5*qa)) + 2*sqr(std::sin(0.25*qa)));
        EXPECT_NEAR(-force(node, 0)/amplitude, expected, 1e-4*expected);
    }
}


TEST(beam, barVibratesWithTheWaveSpeed)
{
    // First longitudinal mode of a free bar: period 2 L/c, c = sqrt(E/rho)
    const scalar a = 0.1, rho = 2;
    auto shape = bodyOf
    (
        latticeBar(100, 4, a),
        a,
        "density 2; E 1e4; areaStiffness 0; calibration vanGelder;",
        "iterations 20;"
    );
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    const scalar L = 100.5*a;
    const scalar quarter = 0.5*L/std::sqrt(E/rho);

    const Eigen::VectorXd start = group->positions().col(0);
    const Eigen::VectorXd modeShape =
        (constant::mathematical::pi/L*(start.array() - 0.5*L)).sin();
    auto mode = [&]()
    {
        return modeShape.dot(group->positions().col(0) - start);
    };
    group->positions().col(0) += 1e-4*a*modeShape;

    const scalar dt = quarter/100;
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(shape->nNodes(), 2);
    scalar time = 0, before = mode(), now = before;
    while (now > 0 && time < 2*quarter)
    {
        before = now;
        run(*group, none, dt, 1);
        time += dt;
        now = mode();
    }
    time -= dt*now/(now - before);
    EXPECT_NEAR(time, quarter, 0.02*quarter);
}


// ************************************************************************* //
