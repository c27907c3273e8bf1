// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples.H"
#include "mathematicalConstants.H"
#include "springCalibration.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4;

const string noArea("density 1; E 1e4; areaStiffness 0; calibration vanGelder;");


//- Mean strain of a body under a uniform stress, at rest
FixedList<scalar, 3> strainUnder
(
    const shapeTemplate& shape,
    const scalar xx,
    const scalar yy,
    const scalar xy
)
{
    auto group = groupOf(shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    settle(*group, traction(shape, xx, yy, xy), 2);
    return meanStrain(*group);
}

const string toTheEnd
(
    "iterations 5000; tolerance 1e-9; areaWeight 0.2; rotation implicitEuler;"
);


//- Deflection over L of cantilevers with L/H = slenderness under the end loads
//  alpha E I/L^2. A beam twice as long with P at each end and 2 P against it
//  in the middle is two cantilevers. Six rows of triangles.
scalarField deflections
(
    const scalarList& alphas,
    const scalar slenderness,
    const string& area
)
{
    const scalar a = 1;
    const label nRows = 6;
    const scalar height = 0.5*std::sqrt(3.0)*a*nRows;
    const label nColumns = std::lround(2*slenderness*height/a);
    auto shape = bodyOf
    (
        latticeBar(nColumns, nRows, a),
        a,
        "density 1e-6; E 1e4; " + area,
        "iterations 20000; tolerance 3e-5; rotation implicitEuler;"
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

    auto group = groupOf(*shape);
    Eigen::MatrixXd force =
        Eigen::MatrixXd::Zero(shape->nNodes(), 2*alphas.size());
    forAll(alphas, copyi)
    {
        group->append(Zero, tensor::I, Zero, Zero, copyi);
        const scalar P = alphas[copyi]*E*pow3(height)/12/sqr(L);
        for (const label i : ends)
        {
            force(i, 2*copyi + 1) = 2*P/ends.size();
        }
        for (const label i : middle)
        {
            force(i, 2*copyi + 1) = -2*P/middle.size();
        }
    }
    settle(*group, force, 2);

    scalarField result(alphas.size(), 0.0);
    forAll(alphas, copyi)
    {
        const auto y = group->positions().col(2*copyi + 1);
        for (const label i : ends)
        {
            result[copyi] += (y[i] - shape->points()[i].y())/ends.size()/L;
        }
        for (const label i : middle)
        {
            result[copyi] -= (y[i] - shape->points()[i].y())/middle.size()/L;
        }
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(material, regularLatticeHasTheModulusInTwoDirections)
{
    // Van Gelder's constants are exact for equilateral triangles, so that the
    // tolerance is for the finite strain of 1e-4 only
    auto shape = bodyOf(latticeBar(20, 8, 0.1), 0.1, noArea, toTheEnd);
    const scalar stress = 1e-4*E;

    const auto along = strainUnder(*shape, stress, 0, 0);
    EXPECT_NEAR(stress/along[0], E, 1e-3*E);
    EXPECT_NEAR(-along[1]/along[0], 1.0/3, 1e-3);

    const auto across = strainUnder(*shape, 0, stress, 0);
    EXPECT_NEAR(stress/across[1], E, 1e-3*E);
    EXPECT_NEAR(-across[0]/across[1], 1.0/3, 1e-3);

    // k = (sqrt(3)/2) E t inside
    EXPECT_NEAR
    (
        max(shape->springConstants()), 0.5*std::sqrt(3.0)*E, 1e-9*E
    );
}


TEST(material, areaTermKeepsTheModulusAndStopsTheAreaChange)
{
    auto shape = bodyOf
    (
        latticeBar(20, 8, 0.1), 0.1, "density 1; E 1e4;", toTheEnd
    );
    const scalar stress = 1e-4*E;
    const auto along = strainUnder(*shape, stress, 0, 0);
    const auto across = strainUnder(*shape, 0, stress, 0);
    EXPECT_NEAR(stress/along[0], E, 2e-3*E);
    EXPECT_NEAR(stress/across[1], E, 2e-3*E);

    // K = 2 mu + kappa/2 with the closed form of springCalibration
    const scalar mu = 0.375*springCalibration::regularFactor(E, 10*E);
    const scalar K = 2*mu + 5;
    EXPECT_NEAR(-along[1]/along[0], (K - mu)/(K + mu), 2e-3);
}


TEST(material, irregularDiscHasTheModulusInTwoDirections)
{
    for (const string area : {"", "areaStiffness 0;"})
    {
        auto shape = disc("density 1; E 1e4; " + area, toTheEnd, 0.0117);
        const scalar stress = 1e-3*E;
        const scalar Ex = stress/strainUnder(*shape, stress, 0, 0)[0];
        const scalar Ey = stress/strainUnder(*shape, 0, stress, 0)[1];
        const scalar shear = strainUnder(*shape, 0, 0, stress)[2];
        EXPECT_NEAR(Ex, E, 0.02*E);
        EXPECT_NEAR(Ey, E, 0.02*E);

        // 2 mu = E/(1 + nu) for what the stretched disc shows
        const scalar nu =
            -strainUnder(*shape, stress, 0, 0)[1]*Ex/stress;
        EXPECT_NEAR(0.5*stress/shear, 0.5*E/(1 + nu), 0.02*E);
    }
}


TEST(material, uncalibratedDiscIsSofter)
{
    // What the calibration is for: Voigt's value is an upper bound
    auto shape = disc(noArea, toTheEnd, 0.0117);
    const scalar stress = 1e-3*E;
    const scalar Ex = stress/strainUnder(*shape, stress, 0, 0)[0];
    EXPECT_LT(Ex, 0.995*E);
    EXPECT_GT(Ex, 0.8*E);
}


TEST(material, thicknessScalesTheForces)
{
    const shapeMesh mesh(latticeBar(8, 4, 0.1));
    auto thin = bodyOf(mesh, 0.1, "density 1; E 1e4;", "", 0.1);
    auto thick = bodyOf(mesh, 0.1, "density 1; E 1e4;", "", 0.2);
    EXPECT_NEAR(thick->mass(), 2*thin->mass(), 1e-12*thick->mass());
    forAll(thin->springConstants(), i)
    {
        EXPECT_NEAR
        (
            thick->springConstants()[i],
            2*thin->springConstants()[i],
            1e-9*thick->springConstants()[i]
        );
    }
}


TEST(material, massesSumToTheBody)
{
    for (const string nodeMass : {"uniform", "area"})
    {
        auto shape = disc("density 1100; E 1e4; nodeMass " + nodeMass + ";");
        EXPECT_NEAR(sum(shape->nodeMasses()), shape->mass(), 1e-9);
        vector centre(Zero);
        forAll(shape->points(), i)
        {
            centre += shape->nodeMasses()[i]*shape->points()[i];
        }
        if (nodeMass == "area")
        {
            EXPECT_LT(mag(centre), 1e-12*shape->mass());
        }
        else
        {
            EXPECT_EQ(max(shape->nodeMasses()), min(shape->nodeMasses()));
        }
    }
}


TEST(material, cantileverBendsAsTheElastica)
{
    // Bisshopp and Drucker's large deflections, to 3 % for L/H = 20
    const scalarField found(deflections(scalarList{1.0, 3.0}, 20, "areaStiffness 0;"));
    EXPECT_NEAR(found[0], 0.30172, 0.03*0.30172);
    EXPECT_NEAR(found[1], 0.60325, 0.03*0.60325);
}


TEST(material, cantileverWithAreaTermBendsAsTheElastica)
{
    // L/H = 10: the shear adds 1 % to the deflection
    const scalarField found(deflections(scalarList{0.25, 1.0}, 10, ""));
    EXPECT_NEAR(found[0], 0.08275, 0.03*0.08275);
    EXPECT_NEAR(found[1], 0.30172, 0.03*0.30172);
}


TEST(material, planeWaveHasTheFrequencyOfTheLattice)
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


TEST(material, barVibratesWithTheWaveSpeed)
{
    // First longitudinal mode of a free bar: period 2 L/c, c = sqrt(E/rho)
    const scalar a = 0.1, rho = 2;
    auto shape = bodyOf
    (
        latticeBar(100, 4, a),
        a,
        "density 2; E 1e4; areaStiffness 0; calibration vanGelder;",
        "iterations 50;"
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

    const scalar dt = quarter/200;
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
