// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "IStringStream.H"
#include "rigidBodies.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar h = 0.2;

contact contactOf(const std::string& text)
{
    return contact(dictionary(IStringStream(text)()), 2, h, 1);
}


//- Outcome of the collision of two discs
struct collision
{
    scalar energyRatio = 0, gap = GREAT;
    scalar momentumError = 0, angularError = 0;

    //- Speeds at which they part and met
    scalar after, before;

    collision(rigidBodies& world, contact& law, const scalar dt, const scalar t)
    {
        const vector p(world.momentum());
        const vector l(world.angularMomentum());
        const scalar e = world.kineticEnergy();
        before = mag(world.solids[1].velocity - world.solids[0].velocity);
        for (label i = 0; i*dt < t; ++i)
        {
            const scalar kinetic = world.kineticEnergy();
            world.advance(law, dt);
            energyRatio = max
            (
                energyRatio, (kinetic + world.statistics.potentialEnergy)/e
            );
            gap = min(gap, world.statistics.smallestGap);
            momentumError = max(momentumError, mag(world.momentum() - p));
            angularError = max(angularError, mag(world.angularMomentum() - l));
        }
        const vector away(world.solids[1].centre - world.solids[0].centre);
        after =
            (world.solids[1].velocity - world.solids[0].velocity)
          & (away/mag(away));
    }
};


rigidBodies headOn(const scalar offset)
{
    rigidBodies world;
    world.add(circleNodes(1, 48), {-1.6, offset/2, 0}, {0.5, 0, 0}, 0.3, 2);
    world.add(circleNodes(1, 48), {1.6, -offset/2, 0}, {-0.5, 0, 0});
    return world;
}

} // End anonymous namespace


TEST(ContactRigid, lawKeepsMomentumAddsNoEnergyParts)
{
    for (const scalar offset : {0.0, 0.7, 1.5})
    {
        for (const scalar courant : {0.02, 0.1, 0.5})
        {
            for (const char* stiffness : {"0.3", "1", "100"})
            {
                rigidBodies world(headOn(offset));
                world.feelLaw = true;
                contact law
                (
                    contactOf("law { stiffness " + word(stiffness) + "; }")
                );
                const collision c(world, law, courant*h/0.5, 12);
                EXPECT_LT(c.energyRatio, 1.001);
                EXPECT_LT(c.momentumError, 1e-12);
                EXPECT_LT(c.angularError, 1e-12);
                EXPECT_GT(c.gap, 0.02*h);
                EXPECT_LT(c.gap, 3*h);
                EXPECT_GT(c.after, 0) << "they stick";
            }
        }
    }
}


TEST(ContactRigid, touchWithoutAStiffness)
{
    for (const scalar e : {1.0, 0.8, 0.5})
    {
        const std::string text
        (
            "law { restitution " + std::to_string(e) + "; }"
        );
        for (const scalar offset : {0.0, 0.7, 1.5})
        {
            for (const scalar courant : {0.02, 0.1, 0.5})
            {
                rigidBodies world(headOn(offset));
                contact law(dictionary(IStringStream(text)()), 2, h, 0);
                const collision c(world, law, courant*h/0.5, 12);
                EXPECT_LT(c.energyRatio, 1 + 1e-10);
                EXPECT_LT(c.momentumError, 1e-12);
                EXPECT_GT(c.gap, 0.05*h);
                EXPECT_GT(c.after, 0.9*e*(1 - offset/2)*c.before);
                if (offset == 0)
                {
                    EXPECT_NEAR(c.after, e*c.before, 0.05*e*c.before);
                }
            }
        }
    }
}


TEST(ContactRigid, touchBelowALawOfAnyStiffness)
{
    // A law that is too weak to hold bodies leaves them to the touch
    for (const char* stiffness : {"1e-9", "1e-3", "0.3", "100"})
    {
        for (const scalar e : {1.0, 0.5})
        {
            for (const scalar courant : {0.02, 0.1, 0.5})
            {
                rigidBodies world(headOn(0));
                contact law
                (
                    contactOf
                    (
                        "law { stiffness " + word(stiffness)
                      + "; restitution " + std::to_string(e) + "; }"
                    )
                );
                const collision c(world, law, courant*h/0.5, 12);
                EXPECT_LT(c.energyRatio, 1.001);
                EXPECT_LT(c.momentumError, 1e-12);
                EXPECT_GT(c.gap, 0.05*h);
                EXPECT_GT(c.after, 0);
                if (word(stiffness) == "1e-9")
                {
                    EXPECT_NEAR(c.after, e*c.before, 0.05*e*c.before);
                }
            }
        }
    }
}


TEST(ContactRigid, wallAndFixedDiscSendBack)
{
    rigidBodies world;
    world.add(circleNodes(1, 48), {0, 0, 0}, {0.5, 0, 0});
    world.add(circleNodes(1, 48), {-3, 0, 0}, Zero, 0, 1, false);
    world.walls.append(contactWall({2, 0, 0}, {-1, 0, 0}));
    contact law(contactOf(""));
    label nTurns = 0;
    for (label i = 0; i < 6000; ++i)
    {
        const scalar v = world.solids[0].velocity.x();
        world.advance(law, 0.01);
        nTurns += v*world.solids[0].velocity.x() < 0;
        ASSERT_GT(world.statistics.smallestGap, 0.1*h);
    }
    EXPECT_GE(nTurns, 8);
    EXPECT_EQ(world.solids[1].centre.x(), -3);
    EXPECT_GT(world.kineticEnergy(), 0.02);
}


TEST(ContactRigid, obstaclesAndWallsDoNotTouchEachOther)
{
    // An obstacle reaches through the wall and into another one
    rigidBodies world;
    world.add(circleNodes(1, 48), {0, 0, 0}, Zero, 0, 1, false);
    world.add(circleNodes(1, 48), {0, 1.9, 0}, Zero, 0, 1, false);
    world.add(circleNodes(1, 48), {-2.1, 0, 0}, {0.5, 0, 0});
    world.walls.append(contactWall({0.5, 0, 0}, {-1, 0, 0}));
    contact law(contactOf(""));
    scalar gap = GREAT;
    for (label i = 0; i < 300; ++i)
    {
        world.advance(law, 0.01);
        ASSERT_LE(world.statistics.contacts, 2);
        gap = min(gap, world.statistics.smallestGap);
        ASSERT_GT(gap, 0.1*h);
    }
    EXPECT_LT(gap, h);
    EXPECT_LT(world.solids[2].velocity.x(), -0.3);
}


TEST(ContactRigid, overlapAtTheStartIsPushedApartWithoutAJump)
{
    rigidBodies world(headOn(0));
    world.feelLaw = true;
    world.solids[0].centre = {-0.97, 0, 0};
    world.solids[1].centre = {0.97, 0, 0};
    for (rigidBodies::solid& d : world.solids)
    {
        d.velocity = Zero;
    }
    contact law(contactOf(""));
    world.advance(law, 0.02);
    ASSERT_LT(world.statistics.smallestGap, -0.05);
    const scalar energy = world.statistics.potentialEnergy;
    for (label i = 0; i < 100; ++i)
    {
        world.advance(law, 0.02);
        EXPECT_LE(world.kineticEnergy(), energy);
    }
    EXPECT_GT(world.statistics.smallestGap, 0);
}


TEST(ContactRigid, adhesionHolds)
{
    // Slow discs stay together at the equilibrium gap, and leave when faster
    for (const scalar speed : {0.05, 2.0})
    {
        rigidBodies world(headOn(0));
        world.solids[0].spin = Zero;
        world.solids[0].velocity = vector(speed/2, 0, 0);
        world.solids[1].velocity = vector(-speed/2, 0, 0);
        contact law
        (
            contactOf("law { type Morse; adhesionEnergy 0.5; stiffness 20; }")
        );
        for (label i = 0; i < 10000; ++i)
        {
            world.advance(law, 0.01);
        }
        if (speed < 1)
        {
            EXPECT_NEAR(world.statistics.smallestGap, h, 0.3*h);
            EXPECT_LT(world.kineticEnergy(), 1e-3);
        }
        else
        {
            EXPECT_EQ(world.statistics.contacts, 0);
        }
    }
}


TEST(ContactRigid, limitStopsTheApproachAtTheMinimumGap)
{
    rigidBodies world(headOn(0));
    world.solids[0].spin = Zero;
    world.solids[0].centre = {-1.05, 0, 0};
    world.solids[1].centre = {1.05, 0, 0};
    contact law(contactOf("minimumGap 0.25;"));
    world.update();
    const scalar dt = 0.2;
    const label n =
        law.limit
        (
            world.surfaces,
            world.surfaces.velocities(),
            world.bodies,
            world.walls,
            dt,
            world.force
        );
    ASSERT_GT(n, 0);
    scalar onFirst = 0;
    for (label i = 0; i < 48; ++i)
    {
        onFirst += world.force[i].x();
    }
    EXPECT_LT(mag(sum(world.force)), 1e-13);

    // 0.1 becomes 0.05: the relative velocity -1 becomes -0.25
    const scalar v = 0.5 + dt*onFirst/2 - (-0.5 - dt*onFirst/1);
    EXPECT_NEAR(v, 0.25, 0.03);
}


// ************************************************************************* //
