// SPDX-License-Identifier: GPL-3.0-or-later

#include "labelPair.H"
#include "surfaceThickness.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;


TEST(surfaceThickness, slantedNotchIsAsThinAsItsArms)
{
    // An L with arms 0.14 wide, its upper end moved along x and y
    for (const scalar moved : {0.0, 0.03, 0.06})
    {
        const pointField foot
        ({
            point(0, 0, 0), point(0.34, 0, 0), point(0.34, 0.14, 0),
            point(0.14, 0.14, 0), point(0.14, 0.36, 0), point(0, 0.36, 0)
        });
        shapeMesh prism;
        prism.points = foot;
        prism.points.append(pointField(foot + vector(moved, moved, 0.25)));
        for (label i = 0; i < 6; ++i)
        {
            const label j = (i + 1) % 6;
            prism.faces.append(surfaceFace({i, j, j + 6}));
            prism.faces.append(surfaceFace({i, j + 6, i + 6}));
        }
        for (const labelPair& side : {labelPair(0, 1), {1, 2}, {4, 5}, {5, 0}})
        {
            const label i = side.first(), j = side.second();
            prism.faces.append(surfaceFace({3, j, i}));
            prism.faces.append(surfaceFace({9, i + 6, j + 6}));
        }
        const scalar found = surfaceThickness::smallest(prism);
        EXPECT_GT(found, 0.13) << moved;
        EXPECT_LT(found, 0.1401) << moved;
    }
}


// ************************************************************************* //
