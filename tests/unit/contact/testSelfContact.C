// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "polygonPredicates.H"
#include "OSspecific.H"
#include "softDiscs.H"

#include <fstream>

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- A C that opens to the right: 3 m x 3 m, arms 1 m wide, the gap between them
//  given
class letterC
{
    //- Dictionary of the shape, after the file of its outline is written
    static std::string dict(const fileName& file, const scalar gap)
    {
        const scalar low = 1.5 - gap/2, high = 1.5 + gap/2;
        std::ofstream(file)
            << "0,0\n3,0\n3," << low << "\n1," << low
            << "\n1," << high << "\n3," << high << "\n3,3\n0,3\n";
        return
            "shape { type polygon; file \"" + file + "\"; }"
            "material { density 1; E 4; areaStiffness 4; }";
    }

public:

    const fileName file;

    softDiscs world;

    explicit letterC(const scalar gap)
    :
        file("/tmp/fsiUnitTests-c-" + Foam::name(pid()) + ".csv"),
        world(dict(file, gap), 0.25)
    {
        world.add(Zero, Zero);
        rm(file);
    }

    //- Give the arms a speed towards each other
    void close(const scalar speed)
    {
        Eigen::MatrixXd& v = world.group.velocities();
        const Eigen::MatrixXd& x = world.group.positions();
        const scalar left = x.col(0).minCoeff(), middle =
            0.5*(x.col(1).minCoeff() + x.col(1).maxCoeff());
        for (Eigen::Index i = 0; i < v.rows(); ++i)
        {
            const scalar along = x(i, 0) - left - 1;
            if (along > 0)
            {
                v(i, 1) = (x(i, 1) > middle ? -0.5 : 0.5)*along*speed;
            }
        }
    }

    bool simple() const
    {
        const label nB = world.shape.nBoundaryNodes();
        pointField polygon(nB, Zero);
        for (label i = 0; i < nB; ++i)
        {
            polygon[i].x() = world.group.positions()(i, 0);
            polygon[i].y() = world.group.positions()(i, 1);
        }
        return polygonPredicates::isSimple(polygon);
    }
};


contact law(const std::string& entries)
{
    const dictionary dict(IStringStream("range 2;" + entries)());
    return contact(dict, 2, 0.2, 4);
}

} // End anonymous namespace


TEST(SelfContact, armsOfASoftBodyCloseAndOpenAgain)
{
    letterC body(0.8);
    body.close(0.8);
    contact standard(law(""));
    const scalar start = body.world.energy();
    const vector p(body.world.momentum());
    scalar energyRatio = 0, gap = GREAT;
    label nTouched = 0;
    for (label i = 0; i < 300; ++i)
    {
        const scalar before = body.world.energy();
        body.world.advance(standard, 0.02);
        const contactStatistics& s = body.world.statistics;
        energyRatio = max(energyRatio, (before + s.potentialEnergy)/start);
        gap = min(gap, s.smallestGap);
        nTouched += s.contacts > 0;
        ASSERT_TRUE(body.simple()) << i;
    }
    std::cout << "smallest gap " << gap << std::endl;
    EXPECT_GT(nTouched, 5);
    EXPECT_EQ(body.world.statistics.contacts, 0) << "it sticks";
    EXPECT_LT(energyRatio, 1.001);
    EXPECT_LT(mag(body.world.momentum() - p), 1e-12);
}


TEST(SelfContact, withoutItTheyCross)
{
    letterC body(0.8);
    body.close(0.8);
    contact without(law("search { selfContact no; }"));
    bool crossed = false;
    for (label i = 0; i < 100 && !crossed; ++i)
    {
        body.world.advance(without, 0.02);
        crossed = !body.simple();
    }
    EXPECT_TRUE(crossed);
}


TEST(SelfContact, aNotchNarrowerThanTheRangeIsAtRest)
{
    letterC body(0.3);
    contact standard(law(""));
    for (label i = 0; i < 10; ++i)
    {
        body.world.advance(standard, 0.02);
    }
    EXPECT_LT(body.world.statistics.smallestGap, 0.31);
    EXPECT_LT(body.world.statistics.potentialEnergy, 1e-12);
    EXPECT_LT(body.world.energy(), 1e-12);

    // but it does not close
    body.close(0.5);
    for (label i = 0; i < 300; ++i)
    {
        body.world.advance(standard, 0.01);
        ASSERT_TRUE(body.simple()) << i;
    }
}


// ************************************************************************* //
