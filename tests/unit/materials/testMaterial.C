// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/energyGradient.H"
#include "samples/equilibrium.H"
#include "springCalibration.H"

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
    equilibrate(*group, traction(shape, xx, yy, xy), 1);
    return meanStrain(*group);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(material, regularLatticeHasTheModulusInTwoDirections)
{
    // Van Gelder's constants are exact for equilateral triangles, so that the
    // tolerance is for the finite strain of 1e-4 only
    auto shape = bodyOf(latticeBar(20, 8, 0.1), 0.1, noArea);
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
        latticeBar(20, 8, 0.1), 0.1, "density 1; E 1e4;"
    );
    const scalar stress = 1e-4*E;
    const auto along = strainUnder(*shape, stress, 0, 0);
    const auto across = strainUnder(*shape, 0, stress, 0);
    EXPECT_NEAR(stress/along[0], E, 2e-3*E);
    EXPECT_NEAR(stress/across[1], E, 2e-3*E);

    // K = 2 mu + kappa/2 with the closed form of springCalibration
    const scalar mu = 0.375*springCalibration::regularFactor(E, 10*E, 2);
    const scalar K = 2*mu + 5;
    EXPECT_NEAR(-along[1]/along[0], (K - mu)/(K + mu), 2e-3);
}


TEST(material, irregularDiscHasTheModulusInAllDirections)
{
    for
    (
        const string area :
        {"", "areaStiffness 0;", "type neoHookean;"}
    )
    {
        auto shape = disc("density 1; E 1e4; " + area, "", 0.0117);
        const scalar stress = 1e-3*E;
        const scalar Ex = stress/strainUnder(*shape, stress, 0, 0)[0];
        const scalar Ey = stress/strainUnder(*shape, 0, stress, 0)[1];
        const scalar shear = strainUnder(*shape, 0, 0, stress)[2];
        EXPECT_NEAR(Ex, E, 0.01*E);
        EXPECT_NEAR(Ey, E, 0.01*E);

        // 2 mu = E/(1 + nu) for what the stretched disc shows
        const scalar nu =
            -strainUnder(*shape, stress, 0, 0)[1]*Ex/stress;
        EXPECT_NEAR(0.5*stress/shear, 0.5*E/(1 + nu), 0.01*E);
    }
}


TEST(material, neoHookeanForceIsTheGradientOfTheEnergy)
{
    auto shape = disc("type neoHookean; density 1; E 1e4;", "", 0.05);
    auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);
    crumple(*group, 5e-3);
    expectGradientOfEnergy(*group, shape->nNodes(), 1e-5);
}


TEST(material, uncalibratedDiscIsSofter)
{
    // The calibration is for this: Voigt's value is an upper bound
    auto shape = disc(noArea, "", 0.0117);
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
    auto shape = disc("density 1100; E 1e4;");
    EXPECT_NEAR(sum(shape->nodeMasses()), shape->mass(), 1e-9);
    vector centre(Zero);
    forAll(shape->points(), i)
    {
        centre += shape->nodeMasses()[i]*shape->points()[i];
    }
    EXPECT_LT(mag(centre), 1e-12*shape->mass());
}


// ************************************************************************* //
