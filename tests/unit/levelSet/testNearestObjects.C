// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearestObjects.H"
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct placedSeed
{
    labelVector at;
    label object;
};


//- Two samples of object 7 and one each of the others
const placedSeed seeds[] =
{
    {{5, 4, 0}, 0}, {{30, 8, 0}, 1}, {{12, 25, 0}, 2}, {{33, 31, 0}, 3},
    {{20, 20, 0}, 7}, {{21, 20, 0}, 7}
};


//- Distances of all objects from a sample, nearest first
std::vector<std::pair<scalar, label>> byDistance(const labelVector& at)
{
    std::vector<std::pair<scalar, label>> all;
    for (const placedSeed& s : seeds)
    {
        const scalar d = std::hypot(at.x() - s.at.x(), at.y() - s.at.y());
        const auto same = std::find_if
        (
            all.begin(), all.end(),
            [&](const auto& other) { return other.second == s.object; }
        );
        if (same == all.end())
        {
            all.push_back({d, s.object});
        }
        else
        {
            same->first = std::min(same->first, d);
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}


nearestObjects marched()
{
    nearestObjects nearest
    (
        cartesianBlock(point::zero, 1, labelVector(40, 36, 1), 2)
    );
    for (const placedSeed& s : seeds)
    {
        nearest.seed(nearest.block().index(s.at), s.object, 0);
    }
    nearest.march();
    return nearest;
}

} // End namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(nearestObjects, distancesAreThoseOfAChamferTransform)
{
    const nearestObjects nearest(marched());
    for (label j = 1; j < 35; ++j)
    {
        for (label i = 1; i < 39; ++i)
        {
            const labelVector at(i, j, 0);
            const auto exact = byDistance(at);
            const auto& found = nearest[nearest.block().index(at)];
            for (label k = 0; k < nearestObjects::nNearest; ++k)
            {
                // The k-th distance is at most 8.24 % above the exact one, and
                // never below
                EXPECT_GE(found.distance[k], exact[k].first*(1 - 1e-6));
                EXPECT_LE(found.distance[k], exact[k].first*1.0824 + 1e-5)
                    << i << ' ' << j << ' ' << k;
            }
        }
    }
}


TEST(nearestObjects, noObjectTwice)
{
    const nearestObjects nearest(marched());
    for (label samplei = 0; samplei < nearest.block().size(); ++samplei)
    {
        const auto& o = nearest[samplei].object;
        for (label k = 1; k < nearestObjects::nNearest; ++k)
        {
            for (label l = 0; l < k; ++l)
            {
                EXPECT_TRUE(o[k] < 0 || o[k] != o[l]);
            }
        }
    }
}


TEST(nearestObjects, nearerSeedTakesThePlace)
{
    nearestObjects::entry e;
    e.take(1, 5);
    e.take(2, 3);
    e.take(3, 4);
    e.take(4, 9);
    e.take(1, 2);
    EXPECT_EQ(e.object[0], 1);
    EXPECT_EQ(e.object[1], 2);
    EXPECT_EQ(e.object[2], 3);
    EXPECT_FLOAT_EQ(e.distance[0], 2);
    EXPECT_FLOAT_EQ(e.distance[2], 4);
}


TEST(nearestObjects, threeDimensions)
{
    nearestObjects nearest
    (
        cartesianBlock(point::zero, 1, labelVector(12, 10, 11), 3)
    );
    nearest.seed(nearest.block().index(labelVector(2, 2, 2)), 0, 0);
    nearest.seed(nearest.block().index(labelVector(9, 7, 8)), 1, 0);
    nearest.march();
    const auto& found = nearest[nearest.block().index(labelVector(8, 7, 8))];
    EXPECT_EQ(found.object[0], 1);
    EXPECT_FLOAT_EQ(found.distance[0], 1);
    EXPECT_EQ(found.object[1], 0);
    const scalar exact = std::sqrt(36.0 + 25 + 36);
    EXPECT_GE(found.distance[1], exact*(1 - 1e-6));
    EXPECT_LE(found.distance[1], exact*1.13);
    EXPECT_EQ(found.object[2], -1);
}


// ************************************************************************* //
