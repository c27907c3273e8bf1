// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"

using namespace Foam;
using Foam::fsi::packing;
using namespace seedBox;

TEST(Placement, shapesHaveTheirPartsOfTheNumberAndTheFraction)
{
    for (const std::string type : {"random", "packed"})
    {
        packing space(emptyBox());
        place
        (
            space,
            "type " + type + "; shapes ((disc 1) (cell 3)); areaFraction 0.2;"
            " minimumGap 0.01; wallGap 0;"
        );
        label nDiscs = 0;
        scalar area = 0;
        for (label i = 0; i < space.size(); ++i)
        {
            nDiscs += space[i].shape == 0;
            area += space.surface(i).volume();
        }
        EXPECT_NEAR(nDiscs, space.size()/4.0, 0.76) << type;
        EXPECT_NEAR(area/2, 0.2, 0.002) << type;
    }
}


TEST(Placement, shapesAreChecked)
{
    const std::string start("type random; number 2; ");
    expectPieces
    (
        errorOf(start + "shapes ((disc 1) (disk 1));"),
        {"disk", "'shapes'", "disc"}
    );
    expectPieces(errorOf(start + "shapes ((disc 0));"), {"'shapes'", "> 0"});
    expectPieces
    (
        errorOf(start + "shape disc; shapes ((disc 1));"),
        {"either", "'shape'", "'shapes'"}
    );
}
