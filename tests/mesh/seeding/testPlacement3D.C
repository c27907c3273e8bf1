// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "rotations.H"
#include "needsThrownErrors.H"

using namespace Foam;
using Foam::fsi::closedSurface;
using Foam::fsi::packing;
using namespace seedBox;

namespace
{

//- Smallest distance of all pairs, images included
scalar smallestGap(const packing& space)
{
    scalar smallest = GREAT;
    for (label i = 0; i < space.size(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            smallest = space.distance(space.surface(i), j, smallest);
        }
    }
    return smallest;
}


fileName csvFile()
{
    return "/tmp/fsiMeshTests-csv3D-" + Foam::name(pid());
}


//- A placement of cells from a file with that text
std::string fromCsv(const std::string& text)
{
    OFstream os(csvFile());
    os  << text.c_str();
    return "type csv; shape cell; file \"" + csvFile() + "\";";
}

} // End namespace


TEST(Placement3D, listedRotationsTurnAsTheySay)
{
    packing space(emptyCube());
    place
    (
        space,
        "type listed; shape cell; objects"
        " ( { centre (0.2 0.2 0.2); }"
        "  { centre (0.6 0.2 0.2); rotation { axis (0 2 0); angle 90; } }"
        "  { centre (0.2 0.7 0.2); rotation { quaternion (2 (2 0 0)); } }"
        "  { centre (0.7 0.7 0.7); rotation 45; velocity (0 0 3);"
        "    angularVelocity (1 2 3); } );"
    );
    ASSERT_EQ(space.size(), 4);

    // The short axis of the cells was z
    const auto span = [&](const label i)
    {
        return space.surface(i).bounds().span();
    };
    EXPECT_NEAR(mag(span(0) - vector(0.24, 0.24, 0.1)), 0, 1e-12);
    EXPECT_NEAR(mag(span(1) - vector(0.1, 0.24, 0.24)), 0, 1e-12);
    EXPECT_NEAR(mag(span(2) - vector(0.24, 0.1, 0.24)), 0, 1e-12);
    EXPECT_EQ(space[3].velocity, vector(0, 0, 3));
    EXPECT_EQ(space[3].angularVelocity, vector(1, 2, 3));

    // A rotation by 90 degrees about y takes z to x
    const vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    EXPECT_LT(mag((space[1].rotation & z) - x), 1e-12);
    EXPECT_LT(mag((space[2].rotation & y) - z), 1e-12);
}


TEST(Placement3D, csvTakesEveryKindOfRotation)
{
    const tensor expected(fsi::rotationAbout({0, 1, 0}, 90));
    const auto rotationIn = [](const std::string& text)
    {
        packing space(emptyCube());
        place(space, fromCsv(text));
        return space[0].rotation;
    };
    for
    (
        const char* text :
        {
            "x,y,z,axisX,axisY,axisZ,angle\n.5,.5,.5,0,3,0,90\n",
            "quaternionW,quaternionX,quaternionY,quaternionZ,x,y,z\n"
            "3,0,3,0,.5,.5,.5\n",
            "x,y,z,eulerX,eulerY,eulerZ\n.5,.5,.5,0,90,0\n"
        }
    )
    {
        EXPECT_LT(mag(rotationIn(text) - expected), 1e-12) << text;
    }

    packing space(emptyCube());
    place
    (
        space,
        fromCsv
        (
            "x,y,z,rotation,angularVelocityX,angularVelocityZ,velocityZ\n"
            ".5,.4,.3,30,1,3,7\n"
        )
    );
    EXPECT_LT(mag(space[0].rotation - rotation(30)), 1e-12);
    EXPECT_EQ(space[0].centre, point(0.5, 0.4, 0.3));
    EXPECT_EQ(space[0].angularVelocity, vector(1, 0, 3));
    EXPECT_EQ(space[0].velocity, vector(0, 0, 7));
    rm(csvFile());
}


TEST(Placement3D, filesOfHemoCellAreRead)
{
    // Turned about x, then about y, then about z; micrometres
    const fileName file(csvFile() + ".pos");
    OFstream(file)()
        << "3\n2e5 3e5 4e5 90 0 90\n7e5 7e5 7e5 0 0 0\n9e5 0 0 0 0 0\n";
    packing space(emptyCube());
    const std::string text("type csv; shape cell; file \"" + file + "\";");
    place(space, text + "misfits leaveOut;");
    ASSERT_EQ(space.size(), 2);
    EXPECT_LT(mag(space[0].centre - point(0.2, 0.3, 0.4)), 1e-12);
    const vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    EXPECT_LT(mag((space[0].rotation & y) - z), 1e-12);
    EXPECT_LT(mag((space[0].rotation & x) - y), 1e-12);
    if (fsi::errorsAreThrown())
    {
        const std::string error(errorIn(emptyCube(), text));
        expectPieces(error, {"object 2", "not in the domain"});
    }
    rm(file);
}


TEST(Placement3D, csvSaysWhatIsWrongWithColumns)
{
    NEEDS_THROWN_ERRORS
    for
    (
        const auto& wrong : std::map<std::string, std::string>
        {
            {"x,y\n.5,.5\n", "columns x and y and z"},
            {"x,y,z,z\n.5,.5,.5,.5\n", "column z is there twice"},
            {"x,y,z,axisX\n.5,.5,.5,1\n", "all or none of the columns"},
            {
                "x,y,z,rotation,axisX,axisY,axisZ,angle\n"
                ".5,.5,.5,1,1,0,0,3\n",
                "more than one kind"
            },
            {
                "x,y,z,axisX,axisY,axisZ,angle\n.5,.5,.5,0,0,0,3\n",
                "axis must not be zero"
            }
        }
    )
    {
        const std::string error(errorIn(emptyCube(), fromCsv(wrong.first)));
        EXPECT_NE(error.find(wrong.second), std::string::npos)
            << wrong.first << error;
    }
    rm(csvFile());
}


TEST(Placement3D, latticesFillTheRegionEvenly)
{
    packing space(emptyCube());
    place(space, "type lattice; shape sphere; counts (2 3 4);");
    ASSERT_EQ(space.size(), 24);
    EXPECT_NEAR(mag(space[0].centre - point(0.25, 1/6.0, 0.125)), 0, 1e-12);
    EXPECT_NEAR(mag(space[23].centre - point(0.75, 5/6.0, 0.875)), 0, 1e-12);

    packing staggered(emptyCube());
    place
    (
        staggered,
        "type lattice; shape cell; spacing (0.3 0.3 0.25);"
        "arrangement staggered;"
    );
    ASSERT_EQ(staggered.size(), 36);
    const auto step = [&](const label i)
    {
        return staggered[i].centre - staggered[0].centre;
    };
    EXPECT_LT(mag(step(3) - vector(0.15, 0.3, 0)), 1e-12);
    EXPECT_LT(mag(step(9) - vector(0.15, 0, 0.25)), 1e-12);
    EXPECT_LT(mag(step(12) - vector(0, 0.3, 0.25)), 1e-12);
}


TEST(Placement3D, randomOnesKeepGapsAcrossSeams)
{
    packing space(emptyCube({1, 1, 1}));
    place(space, "type listed; shape sphere; objects ({ centre (0 0 0); });");
    place
    (
        space,
        "type random; shape cell; number 20; minimumGap 0.03; wallGap 0;"
    );
    EXPECT_EQ(space.size(), 21);
    EXPECT_GE(smallestGap(space), 0.03);
    for (label i = 1; i < space.size(); ++i)
    {
        EXPECT_TRUE(space.surface(i).inside(space.domain(), 0)) << i;
    }

    // Turned about axes other than z
    EXPECT_GT(mag(space[1].rotation.zz() - 1), 1e-3);
}


TEST(Placement3D, objectsThatStartSmallLieInAllDirections)
{
    // Membranes, with their own defaults for gaps and cyclic sides
    packing space
    (
        boundBox(point(0, 0, 0), point(1, 1, 1)), 0.02, {"cell"},
        {ellipsoid({0.12, 0.12, 0.05}, 3)}, vector(1, 1, 0), boolList(),
        pointField(), boolList(1, true)
    );
    place(space, "type packed; shape cell; volumeFraction 0.3; start small;");
    const scalar own = space.shape(0).volume();
    EXPECT_NEAR(space.size()*own, 0.3, 0.51*own);
    EXPECT_GE(smallestGap(space), 0.3*0.02);
    label nAcross = 0;
    scalar along = 0;
    const boundBox layer(point(-1, -1, 0), point(2, 2, 1));
    for (label i = 0; i < space.size(); ++i)
    {
        nAcross += !space.surface(i).inside(space.domain(), 0);
        EXPECT_TRUE(space.surface(i).inside(layer, 0.3*0.02)) << i;
        along += sqr(space[i].rotation.zz())/space.size();
    }
    EXPECT_GT(nAcross, space.size()/5);

    // 1/3 where all directions are equally likely, 1 on a lattice
    EXPECT_NEAR(along, 0.36, 0.12);
}


TEST(Placement3D, packedSpheresReachHalfTheVolume)
{
    const closedSurface sphere(ellipsoid({0.1, 0.1, 0.1}, 3));
    const boundBox box(point(0, 0, 0), point(1.02, 1.02, 0.79));
    packing space(box, 0.02, {"sphere"}, {sphere});
    place
    (
        space,
        "type packed; shape sphere; volumeFraction 0.5; minimumGap 0.002;"
        "wallGap 0; sweeps 50;"
    );
    const scalar size = cmptProduct(box.span());
    EXPECT_NEAR(space.size()*sphere.volume(), 0.5*size, 0.51*sphere.volume());
    EXPECT_GE(smallestGap(space), 0.002);
    for (label i = 0; i < space.size(); ++i)
    {
        EXPECT_TRUE(space.surface(i).inside(box, 0)) << i;
    }
}


// ************************************************************************* //
