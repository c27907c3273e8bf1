// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "labelList.H"
#include "randomNumbers.H"
#include "vector.H"
#include <cstdlib>

using namespace Foam;
using Foam::fsi::randomNumbers;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The next number by the generator of the system's drand48, which has 31
//  bits: two make the 53 of a double
scalar reference()
{
    const double range = 2147483648.0;
    const double low = lrand48();
    const double high = lrand48();
    return (low + high*range)/(range*range);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(RandomNumbers, areThoseOfTheSystemsGenerator)
{
    srand48(17);
    randomNumbers random(17);
    for (label i = 0; i < 100; ++i)
    {
        EXPECT_EQ(random.sample01<scalar>(), reference()) << i;
    }
    const vector v(random.sample01<vector>());
    for (direction d = 0; d < 3; ++d)
    {
        EXPECT_EQ(v[d], reference());
    }
}


TEST(RandomNumbers, betweenHasAllNumbersAndNoOther)
{
    randomNumbers random(3);
    labelList count(4, label(0));
    for (label i = 0; i < 4000; ++i)
    {
        const label n = random.between(5, 8);
        ASSERT_GE(n, 5);
        ASSERT_LE(n, 8);
        ++count[n - 5];
    }
    // Five standard deviations of a binomial distribution
    for (const label n : count)
    {
        EXPECT_NEAR(n, 1000, 5*std::sqrt(4000*0.25*0.75));
    }
}


// ************************************************************************* //
