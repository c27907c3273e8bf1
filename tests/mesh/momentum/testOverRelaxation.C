// SPDX-License-Identifier: GPL-3.0-or-later

#include "overRelaxation.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Rate per sweep of over-relaxation of a consistently ordered matrix whose
//  Jacobi iteration has the spectral radius mu [Young1971]
scalar rate(const scalar mu, const scalar omega)
{
    const scalar discriminant = sqr(omega*mu) - 4*(omega - 1);
    return
        discriminant < 0
      ? omega - 1
      : sqr(0.5*(omega*mu + std::sqrt(discriminant)));
}


//- Sweeps that each multiply the residual by rateOf(factor)
template<class Rate>
void sweep
(
    overRelaxation& relaxation,
    const label nSweeps,
    scalar& residual,
    const Rate& rateOf
)
{
    for (label i = 0; i < nSweeps; ++i)
    {
        relaxation.observe(residual);
        residual *= rateOf(relaxation.factor());
    }
}


//- Factor after some sweeps that converge at the rate of a spectral radius mu
scalar factorAfter(const label nSweeps, const scalar mu, const scalar smallest)
{
    overRelaxation relaxation;
    relaxation.start(smallest);
    scalar residual = 1;
    const auto rateOf = [&](const scalar omega) { return rate(mu, omega); };
    sweep(relaxation, nSweeps, residual, rateOf);
    return relaxation.factor();
}

} // End anonymous namespace


TEST(overRelaxation, findsTheBestFactor)
{
    for (const scalar mu : {0.8, 0.95, 0.99})
    {
        const scalar best = 2/(1 + std::sqrt(1 - sqr(mu)));
        EXPECT_NEAR(factorAfter(20, mu, 1.1), best, 1e-3) << mu;
    }
}


TEST(overRelaxation, keepsAFactorThatIsLargeEnough)
{
    const scalar best = 2/(1 + std::sqrt(1 - sqr(0.8)));
    EXPECT_EQ(factorAfter(20, 0.8, best + 0.1), best + 0.1);
}


TEST(overRelaxation, doesNotBelieveABoundNearTwo)
{
    // Row sums may say mu = 1 of a matrix with a much smaller radius
    overRelaxation relaxation;
    relaxation.start(1.9993);
    scalar residual = 1;
    const auto rateOf = [](const scalar omega) { return rate(0.9, omega); };
    sweep(relaxation, 100, residual, rateOf);
    EXPECT_LT(residual, 1e-8);
}


TEST(overRelaxation, keepsAFactorBelowOne)
{
    EXPECT_EQ(factorAfter(20, 0.9, 0.8), 0.8);
}


TEST(overRelaxation, comesBackFromAResidualThatGrows)
{
    overRelaxation relaxation;
    relaxation.start(1.2);
    scalar residual = 1;
    sweep(relaxation, 7, residual, [](const scalar) { return 0.9; });
    const scalar large = relaxation.factor();
    EXPECT_GT(large, 1.3);
    sweep(relaxation, 40, residual, [](const scalar) { return 1.2; });
    EXPECT_LT(relaxation.factor() - 1.2, 0.1*(large - 1.2));
}


TEST(overRelaxation, startsEverySolutionAnew)
{
    overRelaxation relaxation;
    relaxation.start(1.2);
    for (label i = 0; i < 20; ++i)
    {
        relaxation.observe(std::pow(0.9, i));
    }
    EXPECT_GT(relaxation.factor(), 1.2);
    relaxation.start(1.2);
    EXPECT_EQ(relaxation.factor(), 1.2);
}


// ************************************************************************* //
