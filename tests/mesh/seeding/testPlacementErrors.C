// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "needsThrownErrors.H"

using namespace Foam;
using namespace seedBox;


TEST(Placement, refusesOverlapNamingBothObjects)
{
    NEEDS_THROWN_ERRORS
    expectPieces
    (
        errorOf
        (
            "type listed; shape disc; objects ( { centre (0.5 0.5 0); }"
            "{ centre (0.55 0.5 0); shape cell; } );"
        ),
        {
            "seedObjectsDict", "'objects'", "placement a",
            "object 1 (cell", "overlaps object 0 (disc", "(0.55 0.5 0)"
        }
    );
    expectPieces
    (
        errorOf
        (
            "type listed; shape disc; minimumGap 0.03;"
            "objects ( { centre (0.5 0.5 0); } { centre (0.62 0.5 0); } );"
        ),
        {"object 1", "nearer than minimumGap to object 0", "distance 0.02"}
    );
}


TEST(Placement, refusesPerturbationOfNoVelocity)
{
    NEEDS_THROWN_ERRORS
    const std::string placement =
        "type listed; shape disc; velocityPerturbation 0.1;"
        "objects ({ centre (0.5 0.5 0); });";
    expectPieces
    (
        errorOf(placement),
        {"seedObjectsDict", "'velocityPerturbation'", "placement a", "zero"}
    );
    EXPECT_EQ(errorOf(placement + "velocity (0 1 0);"), "");
}


TEST(Placement, refusesObjectsOutsideTheDomain)
{
    NEEDS_THROWN_ERRORS
    const std::string inside =
        "type listed; shape disc; objects ({ centre (1.94 0.5 0); });";
    EXPECT_EQ(errorOf(inside), "");
    expectPieces
    (
        errorOf(inside + "wallGap 0.02;"),
        {"object 0 (disc", "not in the domain", "wallGap 0.02"}
    );
    expectPieces
    (
        errorOf("type lattice; shape disc; counts (15 1 1); jitter 0;"
            "region { min (0 0 0); max (2 0.02 0); }"),
        {"not in the domain", "and", "more", "'counts'"}
    );
}


TEST(Placement, objectsMayLieAcrossCyclicSides)
{
    NEEDS_THROWN_ERRORS
    const vector period(2, 0, 0);
    const auto listed = [](const std::string& objects)
    {
        return "type listed; shape disc; objects (" + objects + ");";
    };
    const std::string low = listed("{ centre (0.01 0.5 0); }");
    EXPECT_EQ(errorOf(low, period), "");
    EXPECT_NE(errorOf(low), "");
    for (const char* centre : {"(-0.01 0.5 0)", "(2.01 0.5 0)", "(1 0.96 0)"})
    {
        expectPieces
        (
            errorOf
            (
                listed(std::string("{ centre ") + centre + "; }"), period
            ),
            {"object 0", "not in the domain"}
        );
    }

    // Overlap and gaps with images
    expectPieces
    (
        errorOf
        (
            listed("{ centre (0.01 0.5 0); } { centre (1.95 0.5 0); }"), period
        ),
        {"object 1", "overlaps object 0"}
    );
    expectPieces
    (
        errorOf
        (
            listed("{ centre (1.97 0.5 0); } { centre (0.09 0.5 0); }")
          + "minimumGap 0.03;",
            period
        ),
        {"object 1", "nearer than minimumGap to object 0", "distance 0.02"}
    );
    expectPieces
    (
        errorOf
        (
            listed("{ centre (0.01 0.01 0); } { centre (1.99 0.99 0); }"),
            vector(2, 1, 0)
        ),
        {"object 1", "overlaps object 0"}
    );
}


TEST(Placement, saysHowManyFit)
{
    NEEDS_THROWN_ERRORS
    expectPieces
    (
        errorOf("type random; shape disc; areaFraction 0.8; maxAttempts 50;"),
        {"'areaFraction'", "no room for more than", "packed", "minimumGap"}
    );
    expectPieces
    (
        errorOf("type packed; shape disc; number 1000;"),
        {"'number'", "1000", "no room for more than"}
    );
    expectPieces
    (
        errorOf
        (
            "type packed; shape disc; areaFraction 0.6; start small; sweeps 20;"
        ),
        {"'areaFraction'", "20 sweeps", "grown only to 0.", "of its size"}
    );
}


TEST(Placement, refusesWrongEntries)
{
    NEEDS_THROWN_ERRORS
    expectPieces
    (
        errorOf("type heap; shape disc;"),
        {"'heap'", "listed", "lattice", "random", "packed", "csv"}
    );
    expectPieces
    (
        errorOf("type random; shape square; number 1;"),
        {"'square'", "disc", "cell"}
    );
    expectPieces
    (
        errorOf("type random; shape disc; numbers 1;"),
        {"'numbers'", "areaFraction"}
    );
    expectPieces
    (
        errorOf("type random; shape disc; number 1; areaFraction 0.1;"),
        {"'number'", "'areaFraction'"}
    );
    expectPieces
    (
        errorOf("type random; shape disc; number 1; minimumGap -1;"),
        {"'minimumGap'"}
    );
    expectPieces
    (
        errorOf
        (
            "type random; shape disc; number 1;"
            "region { min (1 0 0); max (0 1 0); }"
        ),
        {"'region'", "min < max"}
    );
    for (const std::string type : {"random", "packed"})
    {
        const std::string text =
            "type " + type + "; shape disc; number 1;"
            "region { min (1.5 0 0); max (3 1 0); }";
        for (const vector& period : {vector(0, 0, 0), vector(2, 0, 0)})
        {
            expectPieces
            (
                errorOf(text, period), {"'region'", "lie in the domain"}
            );
        }
    }
    expectPieces
    (
        errorOf("type lattice; shape disc; counts (0 1 1);"), {"'counts'"}
    );
    expectPieces
    (
        errorOf("type lattice; shape disc; spacing (3 0.5 0);"), {"'spacing'"}
    );
}


TEST(Placement, refusesLinesOfAFileByNumber)
{
    NEEDS_THROWN_ERRORS
    const fileName file
    (
        "/tmp/fsiMeshTests-csv-" + Foam::name(pid())
    );
    {
        OFstream os(file);
        os  << "x, y\n0.2, 0.3\n0.4, north\n";
    }
    expectPieces
    (
        errorOf("type csv; shape disc; file \"" + file + "\";"),
        {"line 3", "north", "'file'", "seedObjectsDict"}
    );
    {
        OFstream os(file);
        os  << "x, y\n0.2, nan\n";
    }
    expectPieces
    (
        errorOf("type csv; shape disc; file \"" + file + "\";"),
        {"line 2", "nan", "'file'", "seedObjectsDict"}
    );
    {
        OFstream os(file);
        os  << "x, y, colour\n";
    }
    expectPieces
    (
        errorOf("type csv; shape disc; file \"" + file + "\";"),
        {"line 1", "colour", "rotation"}
    );
    rm(file);
    expectPieces
    (
        errorOf("type csv; shape disc; file \"" + file + "\";"),
        {"cannot be read", file}
    );
}


// ************************************************************************* //
