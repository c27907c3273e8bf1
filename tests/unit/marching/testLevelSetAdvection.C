// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "referenceFlows.H"

#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

TEST(LevelSetAdvection, ThirdOrderOnSmoothWaves)
{
    const errorNorms coarse(waveError(32, 2)), fine(waveError(64, 2));
    EXPECT_GT(convergenceOrder(coarse.mean, fine.mean), 2.9);
    EXPECT_GT(convergenceOrder(coarse.largest, fine.largest), 2.7);
    EXPECT_LT(fine.mean, 2e-4);

    const errorNorms coarse3(waveError(16, 3)), fine3(waveError(32, 3));
    EXPECT_GT(convergenceOrder(coarse3.mean, fine3.mean), 2.7);
}


// Exact for a cubic, whichever stencil is taken, from either side
TEST(LevelSetAdvection, DerivativeIsExactForCubics)
{
    scalarField values(30);
    forAll(values, i)
    {
        const scalar x = 0.1*(i/2);
        values[i] = i % 2 ? GREAT : 1 + x - 2*sqr(x) + 3*pow3(x);
    }
    for (const bool fromBelow : {true, false})
    {
        for (label i = 3; i < 12; ++i)
        {
            const scalar x = 0.1*i;
            EXPECT_NEAR
            (
                levelSetAdvection::derivative(&values[2*i], 2, 0.1, fromBelow),
                1 - 4*x + 9*sqr(x),
                1e-12
            );
        }
    }
}


// Across a kink the stencil stays on the smooth side
TEST(LevelSetAdvection, DerivativeDoesNotLookAcrossAKink)
{
    scalarField values(20);
    forAll(values, i)
    {
        values[i] = mag(i - 9.4);
    }
    for (label i = 3; i < 17; ++i)
    {
        for (const bool fromBelow : {true, false})
        {
            // The interval upwind of sample i that holds the kink is 9..10
            if (i == (fromBelow ? 10 : 9))
            {
                continue;
            }
            EXPECT_NEAR
            (
                levelSetAdvection::derivative(&values[i], 1, 1, fromBelow),
                i <= 9 ? -1 : 1,
                1e-13
            );
        }
    }
}


// In the band a distance carried on stays the distance of the moved circle
TEST(LevelSetAdvection, BandMovesAsTheWholeDoes)
{
    const cartesianBlock block
    (
        cellCentres(-point::one, 2, 64, 2, levelSetAdvection::halo)
    );
    const scalar h = block.spacing();
    const vector v(1, 0.5, 0);
    const vectorField velocity(block.size(), v);
    const auto fillHalo = [&](scalarField& phi) { copyIntoHalo(block, phi); };

    scalarField phi(sampled<scalar>(block, circleDistance));
    phi = max(min(phi, 8*h), -8*h);
    levelSetAdvection advection(8*h);
    const label nSteps = 4;
    for (label step = 0; step < nSteps; ++step)
    {
        advection.advance(block, velocity, 0.25*h, phi, fillHalo);
    }
    EXPECT_LT(advection.band().size(), block.size()/2);

    label nNear = 0;
    forAll(phi, samplei)
    {
        const point p(block.position(samplei) - nSteps*0.25*h*v);
        if (mag(circleDistance(p)) < 2*h)
        {
            ++nNear;
            ASSERT_NEAR(phi[samplei], circleDistance(p), 2e-3*h);
        }
    }
    EXPECT_GT(nNear, 300);
}


// Areas kept and places met after a full turn; the exact area is 582.2
TEST(LevelSetAdvection, ZalesaksDisc)
{
    const cartesianBlock fine(cellCentres(vector::zero, 100, 500, 2));
    EXPECT_NEAR
    (
        enclosedArea(fine, sampled<scalar>(fine, zalesakDistance)), 582.2, 0.1
    );

    bandTreatment band;
    band.bandWidth = 6;
    band.interval = 5;
    const advectionErrors coarse(zalesakError(50, band));
    const advectionErrors errors(zalesakError(100, band));
    EXPECT_LT(mag(errors.area), 0.015);
    EXPECT_LT(errors.mismatch, 0.5);
    EXPECT_LT(errors.mismatch, 0.65*coarse.mismatch);
}


TEST(LevelSetAdvection, ReversedVortex)
{
    const advectionErrors coarse(vortexError(32, 2, bandTreatment()));
    const advectionErrors errors(vortexError(64, 2, bandTreatment()));
    EXPECT_LT(mag(errors.area), 0.03);
    EXPECT_LT(mag(errors.area), 0.4*mag(coarse.area));
    EXPECT_LT(errors.mismatch, 0.2/64);

    bandTreatment band;
    band.bandWidth = 6;
    band.interval = 5;
    const advectionErrors banded(vortexError(64, 2, band));
    EXPECT_LT(mag(banded.area), 0.03);
    EXPECT_LT(banded.mismatch, 0.2/64);
}


TEST(LevelSetAdvection, FillsTheHaloAfterEachStage)
{
    const cartesianBlock block(cellCentres(-point::one, 2, 20, 2));
    scalarField phi(sampled<scalar>(block, circleDistance));
    label nCalls = 0;
    const auto fillHalo = [&](scalarField&) { ++nCalls; };
    levelSetAdvection advection(1);
    advection.advance
    (
        block, vectorField(block.size(), vector(1, 0, 0)), 0.01, phi, fillHalo
    );
    EXPECT_EQ(nCalls, 3);

    // The halo itself is the caller's
    EXPECT_EQ(phi[0], circleDistance(block.position(0)));
}


TEST(LevelSetAdvection, RefusesBadInput)
{
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const cartesianBlock block(cellCentres(-point::one, 2, 20, 2));
    const scalarField good(sampled<scalar>(block, circleDistance));
    const vectorField slow(block.size(), vector(1, 0, 0));
    const auto fillHalo = [](scalarField&) {};
    levelSetAdvection advection(1);

    scalarField phi(good);
    EXPECT_NO_THROW(advection.advance(block, slow, 0.1, phi, fillHalo));
    EXPECT_THROW(advection.advance(block, slow, 0.11, phi, fillHalo), error);

    vectorField bad(slow);
    bad[block.index(10, 4, 0)].y() = nan;
    phi = good;
    EXPECT_THROW(advection.advance(block, bad, 0.01, phi, fillHalo), error);

    phi[0] = nan;
    EXPECT_THROW(advection.advance(block, slow, 0.01, phi, fillHalo), error);

    const cartesianBlock small(cellCentres(-point::one, 2, 6, 2));
    scalarField few(small.size(), 0.1);
    const vectorField still(small.size(), vector::zero);
    EXPECT_THROW(advection.advance(small, still, 0.01, few, fillHalo), error);

    EXPECT_THROW(levelSetAdvection(0), error);
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
