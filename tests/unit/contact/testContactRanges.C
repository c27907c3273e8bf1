// SPDX-License-Identifier: GPL-3.0-or-later

// Bodies that start within the range of contact

#include "rigidSpheres.H"

namespace
{

const scalar h = 0.25;

//- Eight spheres of radius 1 in a lattice, a gap apart along x, y and z, that
//  move towards the middle
rigidBodies lattice(const scalar gap, const scalar speed)
{
    rigidBodies world(3);
    world.feelLaw = true;
    for (label i = 0; i < 8; ++i)
    {
        const vector side(i % 2 ? 1 : -1, i/2 % 2 ? 1 : -1, i/4 ? 1 : -1);
        add
        (
            world, sphereAtOrigin(1, 2), (1 + 0.5*gap)*side,
            -speed*side
        );
    }
    return world;
}


contact contactOf(const std::string& text)
{
    return contact(textDict(text), 3, h, 1000);
}


//- Run from a start at which no ranges are known
void run
(
    rigidBodies& world,
    contact& law,
    const scalar dt,
    const label nSteps,
    scalar& energy
)
{
    for (label i = 0; i < nSteps; ++i)
    {
        world.advance(law, dt);
        energy = max
        (
            energy, world.kineticEnergy() + world.statistics.potentialEnergy
        );
    }
}


scalar largestSpeed(const rigidBodies& world)
{
    scalar speed = 0;
    for (const rigidBodies::solid& s : world.solids)
    {
        speed = max(speed, mag(s.velocity));
    }
    return speed;
}

} // End anonymous namespace


TEST(ContactRanges, startWithinTheRangeIsARest)
{
    for (const scalar cells : {0.05, 0.3, 1.0, 2.5})
    {
        rigidBodies world(lattice(cells*h, 0));
        contact law(contactOf(""));
        law.ranges() = scalarField(8, Zero);
        scalar energy = 0;
        run(world, law, 0.1, 20, energy);
        EXPECT_LT(largestSpeed(world), 1e-12);
        EXPECT_LT(energy, 1e-12);
        for (const scalar range : law.ranges())
        {
            EXPECT_NEAR(range, cells*h, 0.1*h);
        }
    }
}


TEST(ContactRanges, fullRangesFireThemOff)
{
    rigidBodies world(lattice(0.3*h, 0));
    contact law(contactOf(""));
    law.ranges() = scalarField(8, law.range());
    scalar energy = 0;
    run(world, law, 0.1, 2, energy);
    EXPECT_GT(largestSpeed(world), 1);
}


TEST(ContactRanges, attractingLawsKeepTheirs)
{
    rigidBodies world(lattice(0.3*h, 0));
    contact law(contactOf("law { type Morse; adhesionEnergy 1; }"));
    law.ranges() = scalarField(8, Zero);
    scalar energy = 0;
    run(world, law, 0.001, 1, energy);
    EXPECT_GT(largestSpeed(world), 1e-3);
}


TEST(ContactRanges, growWithoutEnergyWhenBodiesPart)
{
    const scalar speed = 0.3;
    rigidBodies world(lattice(0.5*h, speed));
    contact law(contactOf(""));
    law.ranges() = scalarField(8, Zero);
    world.solids[0].velocity *= 0.5;
    const vector momentum(world.momentum());
    const scalar start = world.kineticEnergy();
    scalar energy = 0;
    scalar gap = GREAT;
    for (label i = 0; i < 200; ++i)
    {
        run(world, law, 0.05, 1, energy);
        gap = min(gap, world.statistics.smallestGap);
        EXPECT_LT(mag(world.momentum() - momentum), 1e-10);
    }
    EXPECT_LT(energy, 1.001*start);
    EXPECT_GT(gap, 0);
    EXPECT_LT(gap, 0.5*h);
    // Apart again, so that the next to come meets the full range
    for (const scalar range : law.ranges())
    {
        EXPECT_EQ(range, law.range());
    }
}


//- Spheres of a speed that part: ranges, acting pairs and smallest gap are
//  those of a search without ranges, which has all pairs up to the full range
//  and the margin. Returns the steps in which far fewer pairs were found
static label compareWithFullSearch(const scalar speed)
{
    rigidBodies world(lattice(0.5*h, speed));
    contact law(contactOf(""));
    contact all(contactOf(""));
    law.ranges() = scalarField(8, Zero);
    all.ranges() = law.ranges();
    world.solids[0].velocity *= 0.5;

    const auto acting = [](const contact& c)
    {
        label n = 0;
        for (const contactPair& pair : c.found().pairs)
        {
            n += pair.gap <= c.range()/pair.stretch + h;
        }
        return n;
    };
    scalar energy = 0;
    label nFewer = 0;
    for (label i = 0; i < 100; ++i)
    {
        run(world, law, 0.05, 1, energy);
        const scalarField ranges(all.ranges());
        for (const scalarField& known : {scalarField(), ranges})
        {
            all.ranges() = known;
            all.measure
            (
                world.surfaces,
                world.bodies,
                world.walls,
                UList<medialAxisPoint>()
            );
        }
        EXPECT_EQ(law.ranges(), all.ranges()) << i;
        EXPECT_EQ(acting(law), acting(all)) << i;
        EXPECT_EQ
        (
            world.statistics.smallestGap, all.statistics().smallestGap
        ) << i;
        EXPECT_LE(law.found().pairs.size(), all.found().pairs.size()) << i;
        nFewer += law.found().pairs.size() < 0.7*all.found().pairs.size();
    }
    return nFewer;
}


TEST(ContactRanges, searchGoesAsFarAsTheyNeed)
{
    EXPECT_GT(compareWithFullSearch(0.3), 10);
}


TEST(ContactRanges, searchOfFastOnesGoesFurther)
{
    // They part by more in a step than their ranges look ahead
    compareWithFullSearch(5.5);
}


TEST(ContactRanges, walls)
{
    rigidBodies world(3);
    add(world, sphereAtOrigin(1, 2), {1 + 0.4*h, 0, 0}, Zero);
    world.walls.append(contactWall(Zero, {1, 0, 0}));
    contact law(contactOf(""));
    law.ranges() = scalarField(1, Zero);
    scalar energy = 0;
    run(world, law, 0.1, 5, energy);
    EXPECT_LT(largestSpeed(world), 1e-12);
}


// ************************************************************************* //
