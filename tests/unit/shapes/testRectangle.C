// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeOf.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;


TEST(rectangle, hasItsSizeAndCorners)
{
    const scalar quarter = 0.25*constant::mathematical::pi;
    const string rod("type rectangle; length 0.4; width 0.1; edgeRadius 0.05;");
    EXPECT_NEAR(shapeOf(rod)->volume(), 0.03 + sqr(0.1)*quarter, 1e-6);
    EXPECT_NEAR(shapeOf(rod)->minimumThickness(), 0.1, 2e-3);

    const autoPtr<planarShape> sharp
    (
        shapeOf("type rectangle; length 0.4; width 0.1;")
    );
    EXPECT_EQ(sharp->curve().size(), 4);
    const pointField points(sharp->outline(0.01));
    EXPECT_EQ(points.size(), 100);
    for (const scalar x : {-0.2, 0.2})
    {
        for (const scalar y : {-0.05, 0.05})
        {
            EXPECT_LT(min(mag(points - point(x, y, 0))), 1e-12);
        }
    }

    // All is round, with and without a rounding error in the radius
    for (const char* radius : {"0.05", "0.05000000001"})
    {
        const string text(string("type rectangle; length 0.1; width 0.1; "));
        const pointField circle
        (
            shapeOf(text + "edgeRadius " + radius + ';')->curve()
        );
        EXPECT_EQ(circle.size(), 256);
        EXPECT_NEAR(max(mag(circle)), 0.05, 1e-9);
        EXPECT_NEAR(min(mag(circle)), 0.05, 1e-9);
    }
}


// ************************************************************************* //
