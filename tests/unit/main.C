// SPDX-License-Identifier: GPL-3.0-or-later

/*---------------------------------------------------------------------------*\
Program
    fsiUnitTests

Description
    Runs the tests that need no mesh: tests/unit/<area>/test*.C, GoogleTest.
    OpenFOAM's fatal errors are exceptions here (Foam::error,
    Foam::IOerror), so that a test can expect them:

        EXPECT_THROW(shape::New(dict, 2), Foam::IOerror);

Usage
    fsiUnitTests [--gtest_filter=Suite.Test] [--gtest_repeat=n] ...
\*---------------------------------------------------------------------------*/

#include <gtest/gtest.h>

#include "errorOf.H"

// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    ::testing::InitGoogleTest(&argc, argv);

    const Foam::fsi::thrownErrors thrown;

    return RUN_ALL_TESTS();
}


// ************************************************************************* //
