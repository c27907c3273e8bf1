// SPDX-License-Identifier: GPL-3.0-or-later

// Films between surfaces in space

#include "rigidSpheres.H"

namespace
{

const scalar viscosity = 0.3;


//- Contact with lubrication and next to no repulsion
contact film(const scalar h, const std::string& entries)
{
    return contact
    (
        textDict
        (
            "range 1; law { stiffness 1e-12; tolerance 1e-8; }"
            "lubrication { type Reynolds; viscosity 0.3; " + entries + "}"
        ),
        3, h, 50
    );
}




//- Two spheres along a direction that approach with this relative speed
rigidBodies approaching
(
    const scalar Ra,
    const scalar Rb,
    const scalar gap,
    const scalar speed,
    const label nCuts,
    const scalar mass = 1e8
)
{
    const vector n(normalised(vector(0.3, -0.5, 0.7)));
    rigidBodies world(3);
    add(world, sphereAtOrigin(Ra, nCuts), Zero, 0.5*speed*n, Zero, mass);
    const point apart((Ra + Rb + gap)*n);
    add(world, sphereAtOrigin(Rb, nCuts), apart, -0.5*speed*n, Zero, mass);
    return world;
}


//- Force on the first body along a direction
scalar forceAlong(const rigidBodies& world, const vector& n)
{
    vector sum(Zero);
    for (label i = 0; i < world.surfaces.pointStart()[1]; ++i)
    {
        sum += world.force[i];
    }
    return sum & n/mag(n);
}


//- Force over that of a film between spheres, 6 pi mu a^2 V/gap less what the
//  mesh resolves, with 1/a = 1/Ra + 1/Rb
scalar filmForce(const scalar a, const scalar gap, const scalar cutOff)
{
    // 2 pi int (h^-2 - c^-2) r dr 3 mu a with r dr = a dh
    const scalar integral = 1/gap - 1/cutOff - (cutOff - gap)/sqr(cutOff);
    return 6*constant::mathematical::pi*viscosity*sqr(a)*integral;
}

} // End anonymous namespace


TEST(LubricationSpace, isThatOfReynoldsEquation)
{
    // Nodes every 0.06 R, so that faces lie up to (0.06^2/6) R inside a sphere;
    // gaps from where they resolve the film, sqrt(2 a gap), to where a few
    // nodes hold it. The formula is the first term in gap/a
    for (const scalar Rb : {1.0, 0.6})
    {
        const scalar a = Rb/(1 + Rb);
        for (const scalar gap : {0.01, 0.03, 0.1})
        {
            const scalar inside = 6e-4*(1 + Rb);
            rigidBodies world(approaching(1, Rb, gap, 0.2, 5));
            contact law(film(0.2, "cutOff 1; roughness 1e-3;"));
            world.advance(law, 1e-6);
            const scalar expected = 0.2*filmForce(a, gap, 0.2);
            const scalar found = -forceAlong(world, world.solids[1].centre);
            EXPECT_NEAR(found/expected, 1, 0.02 + inside/gap + 0.2*gap/a)
                << Rb << ' ' << gap;
        }
    }
}


TEST(LubricationSpace, tendsToTheFormulaOfTheSphereAtAWall)
{
    scalar lastError = GREAT;
    for (const label nCuts : {3, 4, 5})
    {
        const scalar gap = 0.02;
        rigidBodies world(3);
        add
        (
            world, sphereAtOrigin(1, nCuts), {0, 0, 1 + gap}, {0, 0, -0.1},
            Zero, 1e8
        );
        world.walls.append(contactWall(Zero, vector(0, 0, 1)));
        contact law(film(0.5, "cutOff 1; roughness 1e-3;"));
        world.advance(law, 1e-6);
        const scalar error = mag
        (
            forceAlong(world, vector(0, 0, 1))/(0.1*filmForce(1, gap, 0.5)) - 1
        );
        EXPECT_LT(error, max(0.5*lastError, 0.005));
        lastError = error;
    }
    EXPECT_LT(lastError, 0.02);
}


TEST(LubricationSpace, takesEnergyKeepsMomentaAndGapsOpenAtAnyTimeStep)
{
    for (const scalar dt : {0.01, 0.2})
    {
        for (const scalar speed : {0.8, -0.8})
        {
            rigidBodies world(approaching(1, 0.7, 0.05, speed, 3, 0.5));
            world.solids[1].spin = vector(0.1, 0.5, -0.2);
            contact law(film(0.2, "roughness 1e-3;"));
            scalar energy = world.kineticEnergy();
            const vector p(world.momentum());
            const vector l(world.angularMomentum());
            for (label i = 0; i*dt < 2; ++i)
            {
                world.advance(law, dt);
                EXPECT_LE(world.kineticEnergy(), energy*(1 + 1e-12));
                energy = world.kineticEnergy();
                ASSERT_GT(world.statistics.smallestGap, 0);
                EXPECT_LT(mag(world.momentum() - p), 1e-10);
                EXPECT_LT(mag(world.angularMomentum() - l), 1e-10);
            }
        }
    }
}


TEST(LubricationSpace, aWeightSinksAsTheFilmLetsIt)
{
    // m g = 6 pi mu a^2 (1/h - ...) |dh/dt|: the time from one gap to another,
    // fifty times as long as the body needs to feel the film
    const scalar weight = 3, mass = 0.5, dt = 0.02, cutOff = 0.2;
    const scalar speed = weight/filmForce(1, 0.1, cutOff);
    scalar expected = 0;
    for (scalar gap = 0.02; gap < 0.1; gap += 1e-5)
    {
        expected += 1e-5*filmForce(1, gap, cutOff)/weight;
    }

    rigidBodies world(3);
    add(world, sphereAtOrigin(1, 4), {0, 0, 1.1}, {0, 0, -speed}, Zero, mass);
    world.walls.append(contactWall(Zero, vector(0, 0, 1)));
    contact law(film(0.2, "cutOff 1; roughness 1e-3;"));
    scalar time = 0;
    while (world.solids[0].centre.z() > 1.02 && time < 10*expected)
    {
        world.solids[0].velocity.z() -= dt*weight/mass;
        world.advance(law, dt);
        time += dt;
    }
    EXPECT_NEAR(time/expected, 1, 0.1);
}


// ************************************************************************* //
