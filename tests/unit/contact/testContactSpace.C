// SPDX-License-Identifier: GPL-3.0-or-later

// Rigid bodies in space

#include "rigidSpheres.H"

namespace
{

const scalar h = 0.25;

contact contactOf(const std::string& text)
{
    return contact(textDict(text), 3, h, 1);
}


//- Outcome of the collision of two bodies
struct meeting
{
    scalar energyRatio = 0, gap = GREAT;
    scalar momentumError = 0, angularError = 0;

    //- No sums of the free bodies where others are fixed
    meeting(rigidBodies& world, contact& law, const scalar dt, const scalar t)
    {
        const vector p(world.momentum());
        const vector l(world.angularMomentum());
        const scalar e = world.kineticEnergy();
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
    }
};


//- Two unequal spheres; the distance of their paths has two components
rigidBodies twoSpheres(const vector& offset)
{
    rigidBodies world(3);
    add
    (
        world, sphereAtOrigin(1, 3), vector(-1.6, 0, 0) + 0.5*offset,
        {0.5, 0, 0}, {0.3, -0.1, 0.2}, 2
    );
    add
    (
        world, sphereAtOrigin(0.8, 3), vector(1.6, 0, 0) - 0.5*offset,
        {-0.5, 0, 0}, Zero
    );
    return world;
}


//- Speed at which the second body leaves the first
scalar parting(const rigidBodies& world)
{
    const rigidBodies::solid& a = world.solids[0];
    const rigidBodies::solid& b = world.solids[1];
    const vector along(b.centre - a.centre);
    return ((b.velocity - a.velocity) & along)/mag(along);
}

} // End anonymous namespace


TEST(ContactSpace, keepsMomentaAddsNoEnergyParts)
{
    for (const vector& offset : {vector::zero, vector(0, 0.4, 0.5)})
    {
        for (const scalar courant : {0.05, 0.4})
        {
            for (const std::string stiffness : {"0.3", "100"})
            {
                rigidBodies world(twoSpheres(offset));
                contact law(contactOf("law { stiffness " + stiffness + "; }"));
                const meeting m(world, law, courant*h/0.5, 8);
                // Normals of facets turn at 0.4 cells in a step
                EXPECT_LT(m.energyRatio, 1.002);
                EXPECT_LT(m.momentumError, 1e-10);
                EXPECT_LT(m.angularError, 1e-10);
                EXPECT_GT(m.gap, 0.02*h);
                EXPECT_LT(m.gap, 3*h);
                EXPECT_GT(parting(world), 0.1);
                EXPECT_EQ(world.statistics.contacts, 0) << "they stick";
            }
        }
    }
}


TEST(ContactSpace, restitutionAsEnteredAtAnyStep)
{
    for (const scalar e : {1.0, 0.8, 0.5})
    {
        contact law
        (
            contactOf("law { restitution " + std::to_string(e) + "; }")
        );
        for (const scalar courant : {0.5, 0.12, 0.03})
        {
            rigidBodies world(twoSpheres(Zero));
            world.solids[0].spin = Zero;
            meeting(world, law, courant*h/0.5, 8);
            const scalar part = e < 0.8 && courant > 0.25 ? 0.15 : 0.05;
            EXPECT_NEAR(parting(world), e, part*e) << "Courant " << courant;
        }
    }
}


TEST(ContactSpace, wallAndFixedSphereSendBack)
{
    rigidBodies world(3);
    add(world, sphereAtOrigin(1, 3), Zero, {0.3, 0.2, 0.4});
    add(world, sphereAtOrigin(1, 3), {-1.8, -1.2, -2.4}, Zero, Zero, 1, false);
    world.walls.append(contactWall({1.2, 0.8, 1.6}, {-0.3, -0.2, -0.4}));
    contact law(contactOf(""));
    label nTurns = 0;
    for (label i = 0; i < 1500; ++i)
    {
        const scalar v = world.solids[0].velocity.z();
        world.advance(law, 0.03);
        nTurns += v*world.solids[0].velocity.z() < 0;
        ASSERT_GT(world.statistics.smallestGap, 0.1*h);
    }

    // Twice by each
    EXPECT_GE(nTurns, 4);
    EXPECT_EQ(world.solids[1].centre.x(), -1.8);
    EXPECT_GT(world.kineticEnergy(), 0.02);
}


TEST(ContactSpace, aBallStaysInACup)
{
    for (const scalar side : {0.0, 0.3})
    {
        rigidBodies world(3);
        add(world, cup(4), Zero, Zero, Zero, 10);
        add
        (
            world, sphereAtOrigin(0.6, 2), {side, side/3, 0.5},
            {0, 0, -0.5}, {0.1, 0.2, 0.3}
        );
        contact law(contactOf("range 1; law { stiffness 20; }"));
        const meeting m(world, law, 0.05, 4);
        EXPECT_LT(m.energyRatio, 1.001);
        EXPECT_LT(m.momentumError, 1e-10);
        EXPECT_LT(m.angularError, 1e-10);
        EXPECT_GT(m.gap, 0.02*h);
        EXPECT_LT(m.gap, 0.8*h);
        EXPECT_GT(world.solids[1].velocity.z(), 0.1);
    }
}


TEST(ContactSpace, lawsPushApartAndPull)
{
    // Signs of the force on the second sphere along the line of the centres,
    // at gaps of 0.1, 0.4 and 0.7; range 0.75
    const auto force = [](const std::string& law, const scalar gap)
    {
        const vector n(0.6, 0, 0.8);
        rigidBodies world(3);
        world.feelLaw = true;
        add(world, sphereAtOrigin(1, 3), Zero, Zero);
        add(world, sphereAtOrigin(1, 3), (2 + gap)*n, Zero);
        contact contacts(contactOf("law { " + law + " }"));
        world.advance(contacts, 1e-4);
        const label start = world.surfaces.pointStart()[1];
        vector sum(Zero);
        for (label i = start; i < 2*start; ++i)
        {
            sum += world.force[i];
        }
        EXPECT_LT(mag(sum ^ n), 0.05*mag(sum) + 1e-12);
        return sum & n;
    };
    const std::string adhesion = "type Morse; adhesionEnergy 3;";
    EXPECT_GT(force(adhesion, 0.1), 0);
    EXPECT_LT(force(adhesion, 0.4), 0);
    EXPECT_GT(force("type elastic;", 0.4), force("type elastic;", 0.7));
    EXPECT_GT(force("type elastic;", 0.7), 0);
    EXPECT_EQ(force("type elastic;", 0.76), 0);
    const std::string thesis = "type thesis; cancel no; restLength 0.9;";
    EXPECT_GT(force(thesis, 0.1), force(thesis, 0.4));
    EXPECT_GT(force(thesis, 0.4), 0);
    EXPECT_EQ(force(thesis, 0.7), 0);
}


// ************************************************************************* //
