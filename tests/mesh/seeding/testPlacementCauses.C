// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "seedBox.H"
#include "needsThrownErrors.H"

using namespace Foam;
using namespace seedBox;


TEST(Placement, namesTheCauseOfAMissingPlace)
{
    NEEDS_THROWN_ERRORS
    // The walls, not other objects
    for (const char* type : {"random", "packed"})
    {
        const std::string sought =
            std::string("type ") + type + "; shape disc; number 1;";
        expectPieces
        (
            errorOf(sought + "wallGap 0.46;"), {"wallGap (0.46 m)", "only 0.08"}
        );
        expectPieces
        (
            errorOf
            (
                sought + "wallGap 0; region { min (0 0 0); max (1 0.09 0); }"
            ),
            {"'region'", "0.09 m", "larger region"}
        );
    }
    expectPieces
    (
        errorOf("type random; shape disc; number 150; maxAttempts 20;"),
        {"too near to other objects", "minimumGap (0.03 m)"}
    );
}


TEST(Placement, refusesAbsurdCounts)
{
    NEEDS_THROWN_ERRORS
    expectPieces
    (
        errorOf("type lattice; shape disc; counts (100000 100000 1);"),
        {"'counts'", "placement a", "objects of shape disc", "no room"}
    );
    expectPieces
    (
        errorOf("type lattice; shape disc; spacing (1e-9 1e-9 0);"),
        {"'spacing'", "no room"}
    );
    expectPieces
    (
        errorOf("type random; shape disc; number 2000000000;"),
        {"'number'", "no room"}
    );
    expectPieces
    (
        errorOf("type random; shape disc; number 1; maxAttempts 2000000000;"),
        {"'maxAttempts'", "2000000000"}
    );
    expectPieces
    (
        errorOf("type packed; shape disc; number 1; sweeps 2000000000;"),
        {"'sweeps'", "2000000000"}
    );
}


TEST(Placement, refusesWhatLeavesThePlane)
{
    NEEDS_THROWN_ERRORS
    const auto listed = [](const std::string& entries)
    {
        return
            "type listed; shape disc; objects ({ centre (0.5 0.5 0); "
          + entries + " });";
    };
    EXPECT_EQ(errorOf(listed("angularVelocity (0 0 3);")), "");
    expectPieces
    (
        errorOf(listed("velocity (0 0 1);")), {"'velocity'", "(0 0 1)"}
    );
    expectPieces
    (
        errorOf(listed("velocity (1e300 0 0);")), {"'velocity'", "1e+300"}
    );
    expectPieces
    (
        errorOf(listed("angularVelocity (1 0 0);")), {"'angularVelocity'"}
    );
    expectPieces
    (
        errorOf(listed("rotation { axis (1 0 0); angle 3; }")),
        {"'rotation'", "a number in two dimensions"}
    );
    expectPieces
    (
        errorOf("type listed; shape disc; objects ({ centre (1 0.5 7); });"),
        {"placement a", "(1 0.5 7)", "out of the plane"}
    );
}


// ************************************************************************* //
