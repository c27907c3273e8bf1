// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "discCrowd.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Run a crowd and check that no two discs ever overlap
void runCrowd(discCrowd& crowd, const label nSteps, const label interval)
{
    const scalar h = 0.6;
    contact law
    (
        dictionary
        (
            IStringStream
            (
                "range 0.5; margin 0.5; law { tolerance 1e-3; }"
            )()
        ),
        2, h, 10
    );
    const scalar dt = 0.25*h/(std::sqrt(2.0)*discCrowd::speed);

    while (crowd.nSteps < nSteps)
    {
        crowd.step(law, dt);
        ASSERT_GT(crowd.statistics.smallestGap, 0) << crowd.nSteps;
        if (crowd.nSteps % interval == 0)
        {
            ASSERT_EQ(crowd.nOverlaps(), 0) << crowd.nSteps;
        }
    }
    std::cout
        << "smallest gap/range " << crowd.smallestGap/law.range()
        << ", contacts per step " << crowd.nContacts/nSteps
        << ", energy ratio " << crowd.energyRatio << std::endl;

    EXPECT_LT(crowd.energyRatio, 1.001);
    EXPECT_GT(crowd.nContacts/nSteps, 0.5*crowd.group.size());
}

} // End anonymous namespace


TEST(ContactCrowd, overlapIsNoticed)
{
    discCrowd crowd(3);
    EXPECT_EQ(crowd.nOverlaps(), 0);
    crowd.group.positions().col(0).array() += 0.9;
    EXPECT_EQ(crowd.nOverlaps(), 1);
    crowd.group.positions().col(0).array() -= 5;
    EXPECT_EQ(crowd.nOverlaps(), 1);
}


TEST(ContactCrowd, hundredDiscsThousandSteps)
{
    discCrowd crowd(10);
    runCrowd(crowd, 1000, 50);
}


TEST(ContactCrowd, longThousandDiscsTenThousandSteps)
{
    discCrowd crowd(32);
    runCrowd(crowd, 10000, 100);
}


// ************************************************************************* //
