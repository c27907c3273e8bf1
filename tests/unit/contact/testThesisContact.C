// SPDX-License-Identifier: GPL-3.0-or-later

#include "lawCases.H"

TEST(ContactLaw, thesisPushesApartAndVanishesAtItsLength)
{
    vector last(vector::max);
    for (const scalar gap : {0.05, 0.15, 0.25})
    {
        rigidBodies world(twoDiscs(60, 60, gap));
        contact law
        (
            dictOf("law { type thesis; cancel no; restLength 0.9; }"),
            2, 0.1, 50
        );
        world.advance(law, 0.01);
        const vector f(forceOn(world, 1));
        EXPECT_GT(f & vector(0.8, 0.6, 0), 0);
        EXPECT_LT(mag(f), mag(last));
        last = f;
    }
    rigidBodies world(twoDiscs(60, 60, 0.28));
    contact law
    (
        dictOf("law { type thesis; cancel no; restLength 0.9; }"), 2, 0.1, 50
    );
    world.advance(law, 0.01);
    EXPECT_EQ(mag(forceOn(world, 1)), 0);
}


TEST(ContactLaw, thesisCancelStopsCollidingNodes)
{
    rigidBodies world(twoDiscs(60, 60, 0.1));
    contact law
    (
        dictOf("law { type thesis; stiffness 1e-12; }"), 2, 0.1, 50
    );
    ASSERT_TRUE(law.needsInternalForces());
    const scalar dt = 0.01;
    world.update();
    world.bodies.internalForces() = vector(1, 2, 0);
    law.calculate
    (
        world.surfaces, world.surfaces.velocities(), world.bodies, world.walls,
        UList<medialAxisPoint>(), contactStep(dt), world.force
    );
    label nStopped = 0;
    forAll(world.force, i)
    {
        if (mag(world.force[i]) > 0)
        {
            const vector impulse(dt*(world.force[i] + vector(1, 2, 0)));
            const vector before
            (
                world.bodies.masses()[i]*world.surfaces.velocities()[i]
            );
            EXPECT_LT(mag(impulse + before), 1e-12);
            ++nStopped;
        }
    }
    EXPECT_GT(nStopped, 4);
}
