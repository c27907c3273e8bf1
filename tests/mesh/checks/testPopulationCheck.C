// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "populationCheck.H"
#include "openfoamVersion.H"
#include "population/someObjects.H"
#include "IStringStream.H"
#include "OStringStream.H"

using namespace Foam;
using Foam::fsi::boxMesh;
using Foam::fsi::boxLayout;
using Foam::fsi::population;
using Foam::fsi::populationCheck;

namespace
{

//- The objects of someObjects in a box of 10 m x 8 m
struct checkedBox
{
    boxMesh box;
    autoPtr<population> objects;

    explicit checkedBox(const boxLayout& layout = boxLayout())
    :
        box(labelVector(10, 8, 1), 2, layout),
        objects(someObjects::make(box.time()))
    {}

    //- Shift a copy of a group
    void move(const label groupi, const label copyi, const vector& shift)
    {
        Eigen::MatrixXd& x = objects->groups()[groupi].positions();
        x.col(2*copyi).array() += shift.x();
        x.col(2*copyi + 1).array() += shift.y();
        objects->updateSurfaces();
    }

    populationCheck::result check
    (
        const scalar tolerance = 1e-3,
        const label nLeft = 0
    )
    {
        return
            populationCheck(box.mesh(), tolerance).check(*objects, nLeft);
    }
};

} // End anonymous namespace


TEST(populationCheck, soundObjectsHaveNoFaults)
{
    checkedBox world;
    const auto found = world.check(1e-12);
    EXPECT_EQ(found.nFaults(), 0);
    EXPECT_EQ(found.objects, 5);
    EXPECT_LT(found.areaChange, 1e-13);
}


TEST(populationCheck, overlapAndOutsideAreNamedById)
{
    checkedBox world;
    world.objects->remove(labelList({0}));
    world.move(0, 0, vector(1.2, 0, 0));
    world.move(1, 0, vector(0, 1.5, 0));
    const auto found = world.check();
    ASSERT_EQ(found.overlapping.size(), 1);
    EXPECT_EQ(found.overlapping[0], labelPair(1, 2));
    EXPECT_EQ(found.outside, labelList({3}));
    EXPECT_EQ(found.missing, labelList({0}));
    EXPECT_EQ(found.nFaults(), 3);

    // The missing one may have left, but only one
    EXPECT_EQ(world.check(1e-3, 1).nFaults(), 2);
    EXPECT_EQ(world.check(1e-3, 2).nFaults(), 3);

    OStringStream text;
    found.write(text);
    EXPECT_NE(text.str().find("1 overlaps"), std::string::npos);
    EXPECT_NE(text.str().find("1 lost"), std::string::npos);
    EXPECT_NE(text.str().find("Objects overlap: (1 2)"), std::string::npos);
}


TEST(populationCheck, areaAndCrossingAndNumbers)
{
    checkedBox world;
    Eigen::MatrixXd& x = world.objects->groups()[0].positions();
    x.col(0) = (2 + (x.col(0).array() - 2)*1.002).matrix();
    x(0, 2) -= 2.5;
    x(0, 4) = std::numeric_limits<scalar>::quiet_NaN();
    world.objects->updateSurfaces();

    const auto found = world.check();
    EXPECT_NEAR(found.areaOff[0], 0, 0);
    EXPECT_EQ(found.crossing, labelList({1}));
    EXPECT_EQ(found.notFinite, labelList({2}));
    EXPECT_EQ(fsi::isIn(world.check(3e-3).areaOff, 0), false);
}


TEST(populationCheck, cyclicSidesRepeatAndAreNoWalls)
{
    boxLayout layout;
    layout.cyclic[0] = true;
    checkedBox world(layout);
    world.move(0, 2, vector(1.5, 0, 0));
    EXPECT_EQ(world.check().nFaults(), 0);
    world.move(0, 2, vector(0.6, 0, 0));
    const auto found = world.check();
    EXPECT_EQ(found.nFaults(), 1);
    EXPECT_EQ(found.overlapping[0], labelPair(0, 2));
}


// ************************************************************************* //
