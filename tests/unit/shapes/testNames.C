// SPDX-License-Identifier: GPL-3.0-or-later

#include "nameCheck.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(badName, thatCannotBeAFileOrAColumnIsRefused)
{
    const dictionary shapes;
    for (const string name : {"disc~", "a,b", "disc.old", "a:b", "a*b", "a b"})
    {
        EXPECT_THROW(checkName(shapes, word(name, false)), Foam::IOerror)
            << name;
    }
    for (const string name : {"disc", "red-cell_2+5um", "sph\xc3\xa8re"})
    {
        EXPECT_NO_THROW(checkName(shapes, word(name, false))) << name;
    }
}


// ************************************************************************* //
