// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "needsThrownErrors.H"
#include "sumOverRanks.H"

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The message of the error of a call; empty if there is none
template<class Call>
std::string errorIn(const Call& call)
{
    try
    {
        call();
    }
    catch (const Foam::error& error)
    {
        return error.message();
    }
    return "";
}


//- The last rank makes its sum in another line than the others
int sumElsewhere()
{
    const bool last = Pstream::myProcNo() == Pstream::nProcs() - 1;
    return
        last
      ? overRanks(1, sumOp<label>())
      : overRanks(1, sumOp<label>());
}

} // End namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(collectiveCalls, samePlaces)
{
    scalarList values(3, 1.0);
    sumOverRanks(values);
    EXPECT_EQ(values, scalarList(3, scalar(Pstream::nProcs())));
    EXPECT_EQ(gatherOverRanks(2), List<int>(Pstream::nProcs(), 2));
}


TEST(collectiveCalls, otherPlaces)
{
    NEEDS_THROWN_ERRORS
    if (Pstream::parRun())
    {
        const std::string message = errorIn(sumElsewhere);
        EXPECT_NE(message.find("testCollectiveCalls.C:38"), std::string::npos)
            << message;
        EXPECT_NE(message.find("testCollectiveCalls.C:39"), std::string::npos)
            << message;
    }
}


TEST(collectiveCalls, otherSizes)
{
    NEEDS_THROWN_ERRORS
    if (Pstream::parRun())
    {
        scalarList values(Pstream::master() ? 2 : 3, 1.0);
        const std::string message = errorIn([&]() { sumOverRanks(values); });
        EXPECT_NE(message.find("2 values"), std::string::npos) << message;
        EXPECT_NE(message.find("3 values"), std::string::npos) << message;
    }
}


// ************************************************************************* //
