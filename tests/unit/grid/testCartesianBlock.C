// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "blockInterpolation.H"
#include "samples/surfaceSamples.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

TEST(CartesianBlock, IndexAndIjkAreInverse)
{
    const cartesianBlock block(point::zero, 0.1, labelVector(5, 4, 3), 3);
    ASSERT_EQ(block.size(), 60);
    for (label samplei = 0; samplei < block.size(); ++samplei)
    {
        EXPECT_EQ(block.index(block.ijk(samplei)), samplei);
        EXPECT_TRUE(block.contains(block.ijk(samplei)));
    }
    EXPECT_EQ(block.index(2, 1, 2), 2 + 5*(1 + 4*2));
    EXPECT_EQ(block.index(1, 2, 1) + block.stride(0), block.index(2, 2, 1));
    EXPECT_EQ(block.index(1, 2, 1) + block.stride(1), block.index(1, 3, 1));
    EXPECT_EQ(block.index(1, 2, 1) + block.stride(2), block.index(1, 2, 2));
    EXPECT_FALSE(block.contains(labelVector(5, 0, 0)));
    EXPECT_FALSE(block.contains(labelVector(0, -1, 0)));
}


TEST(CartesianBlock, PositionsAgreeBitwiseBetweenBlocksOfOneLattice)
{
    const point origin(0.1, -0.7, 1e-3);
    const scalar h = 1.0/3;
    const cartesianBlock whole(origin, h, labelVector(40, 30, 20), 3);
    const labelVector start(17, 11, 13);
    const cartesianBlock part(origin, h, labelVector(9, 8, 7), 3, start);

    for (label samplei = 0; samplei < part.size(); ++samplei)
    {
        const point p(part.position(samplei));
        const point q(whole.position(part.ijk(samplei) + start));
        EXPECT_EQ(p.x(), q.x());
        EXPECT_EQ(p.y(), q.y());
        EXPECT_EQ(p.z(), q.z());
    }
}


TEST(CartesianBlock, RangeHoldsAllSamplesBetweenTwoCoordinates)
{
    const labelVector start(3, -2, 0);
    const cartesianBlock block
    (
        point(0.05, 0.05, 0), 0.1, labelVector(10, 8, 1), 2, start
    );
    for (scalar lower = -1.03; lower < 2; lower += 0.0371)
    {
        for (const scalar width : {0.0, 0.04, 0.25, 3.0})
        {
            label first, last;
            block.range(lower, lower + width, 0, first, last);
            EXPECT_GE(first, 3);
            EXPECT_LE(last, 12);
            for (label i = 3; i < 13; ++i)
            {
                const scalar x = block.latticePosition(i, 0);
                if (x >= lower && x <= lower + width)
                {
                    EXPECT_LE(first, i);
                    EXPECT_GE(last, i);
                }
                else if (x < lower - 0.1001 || x > lower + width + 0.1001)
                {
                    EXPECT_FALSE(first <= i && i <= last);
                }
            }
        }
    }

    // Any distance away, beyond the range of a label
    label first, last;
    block.range(1e200, 2e200, 0, first, last);
    EXPECT_GT(first, last);
    block.range(-2e200, -1e200, 0, first, last);
    EXPECT_GT(first, last);
}


TEST(BlockInterpolation, LinearIsExactForLinearFunctions)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 8, 3));
    const auto f = [](const point& p)
    {
        return 1 + 2*p.x() - p.y() + 3*p.z();
    };
    const scalarField values(sampled<scalar>(block, f));

    scalar value = 0;
    for (const point& p : {point(0.3, 0.77, 0.5), point(0.0625, 0.9375, 0.9)})
    {
        ASSERT_TRUE(interpolateLinear(block, values, p, value));
        EXPECT_NEAR(value, f(p), 1e-14);
    }
    EXPECT_FALSE(interpolateLinear(block, values, point(0, 0.5, 0.5), value));
    EXPECT_FALSE(interpolateLinear(block, values, point(0.5, 2, 0.5), value));

    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    EXPECT_FALSE
    (
        interpolateLinear(block, values, point(nan, 0.5, 0.5), value)
    );
}


TEST(BlockInterpolation, CubicIsExactForCubicFunctionsUpToTheEnds)
{
    for (const direction nDims : {2, 3})
    {
        const cartesianBlock block(cellCentres(vector::zero, 1, 6, nDims));
        const scalar c = nDims == 3 ? 1 : 0;
        const auto f = [=](const point& p)
        {
            return pow3(p.x())*sqr(p.y()) - pow3(p.y()) + c*pow3(p.z())*p.x();
        };
        const scalarField values(sampled<scalar>(block, f));

        for (const scalar x : {0.084, 0.3, 0.5, 0.91})
        {
            const point p(x, 0.9 - 0.8*x, nDims == 3 ? 0.6 : 0);
            scalar value;
            vector gradient;
            ASSERT_TRUE(interpolateCubic(block, values, p, value, gradient));
            EXPECT_NEAR(value, f(p), 1e-14);

            const vector exact
            (
                3*sqr(p.x()*p.y()) + c*pow3(p.z()),
                2*pow3(p.x())*p.y() - 3*sqr(p.y()),
                3*c*sqr(p.z())*p.x()
            );
            EXPECT_NEAR(mag(gradient - exact), 0, 1e-12);
        }
    }
}


TEST(BlockInterpolation, CubicNeedsFourSamples)
{
    const cartesianBlock block(cellCentres(vector::zero, 1, 3, 2));
    scalar value;
    vector gradient;
    EXPECT_FALSE
    (
        interpolateCubic
        (
            block, scalarField(9, 1.0), point(0.5, 0.5, 0), value, gradient
        )
    );
}

} // End namespace fsi
} // End namespace Foam

// ************************************************************************* //
