// SPDX-License-Identifier: GPL-3.0-or-later

// Coulomb's friction

#include "rigidSpheres.H"

namespace
{

const scalar h = 0.2;
const scalar g = 10;


contact frictionOf(const direction nDims, const std::string& mu)
{
    return contact
    (
        textDict
        (
            "range 1; law { stiffness 50; restitution 0.5;"
            " frictionCoefficient " + mu + "; tolerance 1e-8;"
            " maxSweeps 1000; }"
        ),
        nDims, h, 1
    );
}


//- Outline of a block of 4 by 1, counter-clockwise
pointField block()
{
    DynamicList<point> nodes;
    const label n = 8;
    const scalar d = 4.0/n;
    for (label i = 0; i < n; ++i)
    {
        nodes.append(point(-2 + i*d, -0.5, 0));
    }
    for (label i = 0; i < n/4; ++i)
    {
        nodes.append(point(2, -0.5 + i*d, 0));
    }
    for (label i = 0; i < n; ++i)
    {
        nodes.append(point(2 - i*d, 0.5, 0));
    }
    for (label i = 0; i < n/4; ++i)
    {
        nodes.append(point(-2, 0.5 - i*d, 0));
    }
    return pointField(nodes);
}


//- A body under gravity that is tilted by an angle, on a floor at y = 0
void slide
(
    rigidBodies& world,
    contact& law,
    const scalar angle,
    const label nSteps,
    const scalar dt
)
{
    for (label i = 0; i < nSteps; ++i)
    {
        for (rigidBodies::solid& s : world.solids)
        {
            if (s.free)
            {
                s.velocity += dt*g*vector(std::sin(angle), -std::cos(angle), 0);
            }
        }
        world.advance(law, dt);
    }
}


rigidBodies onFloor(const bool smooth = false, const vector& speed = Zero)
{
    rigidBodies world;
    world.add(block(), {0, 0.69, 0}, Zero, 0, 2);
    world.walls.append(contactWall(Zero, {0, 1, 0}, smooth));
    world.walls[0].setVelocity(speed);
    return world;
}

} // End anonymous namespace


TEST(Friction, blockSlidesDownAsCoulombSays)
{
    const scalar angle = 0.5, mu = 0.3, dt = 0.002;
    rigidBodies world(onFloor());
    contact law(frictionOf(2, "0.3"));
    slide(world, law, angle, 300, dt);
    const vector v(world.solids[0].velocity);

    // The normal impulses are what gravity has lost, whatever the bounces
    const scalar t = 300*dt;
    EXPECT_NEAR
    (
        v.x(),
        g*t*std::sin(angle) - mu*(g*t*std::cos(angle) + v.y()),
        1e-6
    );
    EXPECT_NEAR(v.x()/t, g*(std::sin(angle) - mu*std::cos(angle)), 0.02);
}


TEST(Friction, blockSticks)
{
    rigidBodies world(onFloor());
    contact law(frictionOf(2, "0.6"));
    slide(world, law, 0.5, 200, 0.002);
    const scalar landed = world.solids[0].centre.x();
    slide(world, law, 0.5, 200, 0.002);
    EXPECT_LT(mag(world.solids[0].velocity.x()), 1e-6);
    EXPECT_LT(mag(world.solids[0].centre.x() - landed), 1e-5*h);

    // Pushed, it slides until it sticks again, by v^2/2 over the deceleration
    const scalar x = world.solids[0].centre.x();
    world.solids[0].velocity.x() += 1;
    slide(world, law, 0, 400, 0.002);
    EXPECT_LT(mag(world.solids[0].velocity.x()), 1e-6);
    EXPECT_NEAR(world.solids[0].centre.x() - x, 1/(2*0.6*g), 0.004);
}


TEST(Friction, wallsCarryAlongUnlessTheyAreSmooth)
{
    contact law(frictionOf(2, "0.6"));
    rigidBodies belt(onFloor(false, {0.5, 0, 0}));
    slide(belt, law, 0, 300, 0.002);
    EXPECT_NEAR(belt.solids[0].velocity.x(), 0.5, 1e-6);

    rigidBodies smooth(onFloor(true, {0.5, 0, 0}));
    slide(smooth, law, 0.3, 300, 0.002);
    EXPECT_NEAR(smooth.solids[0].velocity.x(), 0.6*g*std::sin(0.3), 1e-9);
}


TEST(Friction, keepsMomentaAndAddsNoEnergy)
{
    for (const char* mu : {"0.05", "0.5", "5"})
    {
        rigidBodies world;
        world.add(circleNodes(1, 48), {-1.3, 0.3, 0}, {0.5, 0, 0}, 3, 2);
        world.add(circleNodes(0.8, 40), {1.3, -0.3, 0}, {-0.5, 0, 0});
        contact law(frictionOf(2, mu));
        const vector p(world.momentum());
        const vector l(world.angularMomentum());
        scalar last = GREAT;
        for (label i = 0; i < 600; ++i)
        {
            const scalar kinetic = world.kineticEnergy();
            world.advance(law, 0.005);
            const scalar energy = kinetic + world.statistics.potentialEnergy;
            EXPECT_LT(energy, 1.0005*last);
            last = energy;
            EXPECT_LT(mag(world.momentum() - p), 1e-11);
            EXPECT_LT(mag(world.angularMomentum() - l), 1e-11);
        }
        EXPECT_EQ(world.statistics.contacts, 0);
        EXPECT_LT(mag(world.solids[0].spin.z()), 2.99);
        EXPECT_GT(mag(world.solids[1].spin.z()), 0.01);
    }
}


TEST(Friction, spheresTurnEachOther)
{
    rigidBodies world(3);
    add
    (
        world, sphereAtOrigin(1, 2), {-1.3, 0.1, -0.2}, {0.5, 0, 0},
        {0.5, 2, -3}, 2
    );
    add(world, sphereAtOrigin(0.8, 2), {1.3, -0.1, 0.2}, {-0.5, 0, 0});
    contact law(frictionOf(3, "0.4"));
    const vector p(world.momentum());
    const vector l(world.angularMomentum());
    const scalar before = world.kineticEnergy();
    for (label i = 0; i < 400; ++i)
    {
        world.advance(law, 0.005);
        EXPECT_LT(mag(world.momentum() - p), 1e-11);
        EXPECT_LT(mag(world.angularMomentum() - l), 1e-11);
    }
    EXPECT_EQ(world.statistics.contacts, 0);
    EXPECT_LT(world.kineticEnergy(), before);
    EXPECT_GT(mag(world.solids[1].spin), 0.05);
}


TEST(Friction, coefficientIsChecked)
{
    EXPECT_THROW(frictionOf(2, "-0.1"), Foam::IOerror);
    EXPECT_THROW(frictionOf(2, "11"), Foam::IOerror);
    EXPECT_THROW
    (
        contact(textDict("law { type none; frictionCoefficient 1; }"), 2, h, 1),
        Foam::IOerror
    );
}
