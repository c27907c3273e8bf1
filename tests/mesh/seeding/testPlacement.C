// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"
#include "OFstream.H"
#include "OSspecific.H"

using namespace Foam;
using Foam::fsi::closedSurface;
using Foam::fsi::packing;
using namespace seedBox;

namespace
{

//- Smallest distance of all pairs
scalar smallestGap(const packing& space)
{
    scalar smallest = GREAT;
    for (label i = 0; i < space.size(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            smallest = min
            (
                smallest,
                space.surface(i).distance(space.surface(j))
            );
        }
    }
    return smallest;
}


//- Area of all objects over that of the box
scalar areaFraction(const packing& space)
{
    scalar sum = 0;
    for (label i = 0; i < space.size(); ++i)
    {
        sum += space.surface(i).volume();
    }
    return sum/2;
}


//- Expect every object in a box
void expectInside(const packing& space, const boundBox& box)
{
    for (label i = 0; i < space.size(); ++i)
    {
        EXPECT_TRUE(space.surface(i).inside(box, 0)) << i;
    }
}

} // End namespace


TEST(Placement, listedObjectsAreWhereTheyAreListed)
{
    packing space(emptyBox());
    place
    (
        space,
        "type listed; shape disc; velocity (1 0 0); objects"
        " ( { centre (0.2 0.3 0); }"
        "  { centre (1 0.5 0); rotation 90; shape cell; velocity (0 2 0);"
        "    angularVelocity (0 0 3); } );"
    );
    ASSERT_EQ(space.size(), 2);
    EXPECT_EQ(space[0].centre, point(0.2, 0.3, 0));
    EXPECT_EQ(space[0].velocity, vector(1, 0, 0));
    EXPECT_EQ(space[1].shape, 1);
    EXPECT_EQ(space[1].velocity, vector(0, 2, 0));
    EXPECT_EQ(space[1].angularVelocity, vector(0, 0, 3));
    EXPECT_NEAR(space.surface(1).bounds().span().y(), 0.16, 1e-12);
}


TEST(Placement, latticeFillsTheRegionEvenly)
{
    packing space(emptyBox());
    place
    (
        space,
        "type lattice; shape disc; counts (4 2 1);"
        "region { min (1 0 0); max (2 1 0); }"
    );
    ASSERT_EQ(space.size(), 8);
    EXPECT_NEAR(mag(space[0].centre - point(1.125, 0.25, 0)), 0, 1e-12);
    EXPECT_NEAR(mag(space[7].centre - point(1.875, 0.75, 0)), 0, 1e-12);
}


TEST(Placement, latticeOfGivenSpacingMayBeStaggered)
{
    packing space(emptyBox());
    place
    (
        space,
        "type lattice; shape disc; spacing (0.19 0.25 0);"
        "arrangement staggered;"
    );
    ASSERT_EQ(space.size(), 40);
    EXPECT_NEAR(space[1].centre.x() - space[0].centre.x(), 0.19, 1e-12);
    EXPECT_NEAR(space[10].centre.x() - space[0].centre.x(), 0.095, 1e-12);
    EXPECT_NEAR(space[10].centre.y() - space[0].centre.y(), 0.25, 1e-12);
    expectInside(space, space.domain());
}


TEST(Placement, randomKeepsGapRegionAndNumber)
{
    packing space(emptyBox());
    place(space, "type listed; shape disc; objects ({ centre (1 0.5 0); });");
    place
    (
        space,
        "type random; shape cell; number 30; minimumGap 0.02; wallGap 0.05;"
        "region { min (0.5 0 0); max (2 1 0); }"
    );
    EXPECT_EQ(space.size(), 31);
    EXPECT_GE(smallestGap(space), 0.02);
    expectInside
    (
        space, boundBox(point(0.5, 0.05, 0), point(1.95, 0.95, 0))
    );

    // Random rotations are not all alike
    EXPECT_GT(mag(space[1].rotation - space[2].rotation), 1e-3);
}


TEST(Placement, randomDefaultGapIsThreeCells)
{
    packing space(emptyBox());
    place(space, "type random; shape disc; number 60;");
    EXPECT_GE(smallestGap(space), 0.03);
    EXPECT_LT(smallestGap(space), 0.04);
    expectInside
    (
        space, boundBox(point(0.03, 0.03, 0), point(1.97, 0.97, 0))
    );
}


TEST(Placement, seedDecidesTheRandomNumbers)
{
    const std::string text =
        "type random; shape disc; number 10; velocity (1 0 0);"
        "velocityPerturbation 0.1;";
    packing a(emptyBox()), b(emptyBox()), c(emptyBox());
    place(a, text + "seed 4;");
    place(b, text + "seed 4;");
    place(c, text + "seed 5;");

    scalar mean = 0;
    for (label i = 0; i < 10; ++i)
    {
        EXPECT_EQ(a[i].centre, b[i].centre);
        EXPECT_EQ(a[i].velocity, b[i].velocity);
        EXPECT_NE(a[i].centre, c[i].centre);
        const scalar perturbation = mag(a[i].velocity - vector(1, 0, 0));
        EXPECT_LE(perturbation, 0.1);
        mean += perturbation/10;
    }
    EXPECT_GT(mean, 0.03);
}


TEST(Placement, packedDiscsReachHalfTheArea)
{
    packing space(emptyBox());
    place
    (
        space,
        "type packed; shape disc; areaFraction 0.5; minimumGap 0.01; sweeps 50;"
    );
    EXPECT_NEAR(areaFraction(space), 0.5, 0.005);
    EXPECT_GE(smallestGap(space), 0.01);
    expectInside
    (
        space, boundBox(point(0.01, 0.01, 0), point(1.99, 0.99, 0))
    );
}


TEST(Placement, packedFindsMoreThanRandomBesideOthers)
{
    packing others(emptyBox());
    place
    (
        others,
        "type random; shape cell; number 25; minimumGap 0.02; seed 3;"
    );
    const auto mostOf = [&](const std::string& type)
    {
        const std::string text = seedBox::errorIn
        (
            others, "type " + type + "; shape disc; number 140;"
            "minimumGap 0.02;"
        );
        const std::string before = "no room for more than ";
        const std::size_t found = text.find(before);
        return
            found == std::string::npos
          ? -1
          : std::stoi(text.substr(found + before.size()));
    };
    const label random = mostOf("random"), packed = mostOf("packed");
    EXPECT_GT(random, 20);
    EXPECT_GE(packed, 1.1*random);
    std::cout
        << "random " << random << ", packed " << packed << std::endl;
}


TEST(Placement, packedSlenderBodiesForgetTheLattice)
{
    packing space(emptyBox());
    place
    (
        space,
        "type packed; shape cell; areaFraction 0.45; minimumGap 0.005;"
        "sweeps 200;"
    );
    EXPECT_NEAR(areaFraction(space), 0.45, 0.005);
    EXPECT_GE(smallestGap(space), 0.005);

    // Order of the axes: 1 on the lattice
    vector order(Zero);
    for (label i = 0; i < space.size(); ++i)
    {
        const scalar c = space[i].rotation.xx(), s = space[i].rotation.yx();
        order += vector(sqr(c) - sqr(s), 2*s*c, 0)/space.size();
    }
    EXPECT_LT(mag(order), 0.6);
}


TEST(Placement, csvRowsReplaceTheDictionary)
{
    const fileName file
    (
        "/tmp/fsiMeshTests-csv-" + Foam::name(pid())
    );
    {
        OFstream os(file);
        os  << "# comment\nshape, x, y, rotation, velocityX\n"
            << "disc, 0.2, 0.3, 0, 1.5\n\ncell, 1, 0.5, 90, -1\n";
    }
    packing space(emptyBox());
    place
    (
        space,
        "type csv; shape disc; velocity (0 7 0); file \"" + file + "\";"
    );
    ASSERT_EQ(space.size(), 2);
    EXPECT_EQ(space[0].velocity, vector(1.5, 7, 0));
    EXPECT_EQ(space[1].shape, 1);
    EXPECT_NEAR(space.surface(1).bounds().span().y(), 0.16, 1e-12);

    rm(file);
}


// ************************************************************************* //
