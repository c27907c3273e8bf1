// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "lawCases.H"

namespace
{

const scalar viscosity = 0.3;


//- Contact with lubrication and next to no repulsion; h = 0.2, range h
contact film(const std::string& entries)
{
    return contact
    (
        dictOf
        (
            "range 1; law { stiffness 1e-12; tolerance 1e-8; }"
            "lubrication { type Reynolds; viscosity 0.3; " + entries + "}"
        ),
        2, 0.2, 50
    );
}


//- Two equal discs of radius 1 with a gap, each at this speed towards the
//  other; or ellipses with these semi-axes across
rigidBodies approaching
(
    const scalar gap,
    const scalar speed,
    const scalar mass,
    const label n = 180,
    const scalar across = 1
)
{
    pointField nodes(circleNodes(1, n));
    for (point& x : nodes)
    {
        x.y() *= across;
    }
    rigidBodies world;
    world.add(nodes, {-1 - gap/2, 0, 0}, {speed, 0, 0}, 0, mass);
    world.add(nodes, {1 + gap/2, 0, 0}, {-speed, 0, 0}, 0, mass);
    return world;
}


//- Resistance of the film over 6 mu R V, by quadrature of Reynolds' pressure
scalar filmIntegral(const scalar gap, const scalar cutOff, const scalar R)
{
    const scalar dx = 1e-5;
    scalar sum = 0;
    for (scalar x = 0.5*dx; gap + sqr(x)/(2*R) < cutOff; x += dx)
    {
        sum += 2*dx*(1/sqr(gap + sqr(x)/(2*R)) - 1/sqr(cutOff));
    }
    return sum;
}


//- Distance of the two discs
scalar gapOf(const rigidBodies& world)
{
    return mag(world.solids[1].centre - world.solids[0].centre) - 2;
}

} // End anonymous namespace


TEST(Lubrication, isThatOfReynoldsEquation)
{
    for (const scalar gap : {0.004, 0.01, 0.02})
    {
        rigidBodies world(approaching(gap, 0.1, 1e8, 720));
        contact law(film("cutOff 0.25;"));
        world.advance(law, 1e-5);
        const scalar expected =
            6*viscosity*0.5*0.2*filmIntegral(gap, 0.05, 0.5);
        EXPECT_NEAR(-forceOn(world, 0).x()/expected, 1, 0.03) << gap;
    }
}


TEST(Lubrication, takesTheCurvatureOfThePlace)
{
    const scalar gap = 0.01;
    for (const scalar across : {0.5, 0.8})
    {
        // The tips of the ellipses have the radius across^2
        const scalar R = 0.5*sqr(across);
        rigidBodies world(approaching(gap, 0.1, 1e8, 1440, across));
        contact law(film("cutOff 0.25;"));
        world.advance(law, 1e-5);
        const scalar expected = 6*viscosity*R*0.2*filmIntegral(gap, 0.05, R);
        EXPECT_NEAR(-forceOn(world, 0).x()/expected, 1, 0.03) << across;
    }
}


TEST(Lubrication, filmsOfFlatPlacesAreAsLongAsTheirBodies)
{
    // The circle with the ellipse's perimeter
    const scalar gap = 0.01, across = 2, perimeter = 9.68845;
    const scalar R = 0.25*perimeter/constant::mathematical::pi;
    rigidBodies world(approaching(gap, 0.1, 1e8, 1440, across));
    contact law(film("cutOff 0.25;"));
    world.advance(law, 1e-5);

    // Over surfaces with the ellipses' gaps
    const scalar expected =
        6*viscosity*R*0.2*filmIntegral(gap, 0.05, 0.5*sqr(across));
    EXPECT_NEAR(-forceOn(world, 0).x()/expected, 1, 0.03);
}


TEST(Lubrication, tendsToTheFormulaOfTheCylinder)
{
    const scalar gap = 0.004, speed = 0.2;
    rigidBodies world(approaching(gap, speed/2, 1e8, 720));
    contact law(film("cutOff 1;"));
    world.advance(law, 1e-5);
    const scalar expected =
        3*Foam::sqrt(2.0)*constant::mathematical::pi*viscosity*speed
       *Foam::pow(0.5/gap, 1.5);
    EXPECT_NEAR(-forceOn(world, 0).x()/expected, 1, 0.03);
}


TEST(Lubrication, pullsByNoMoreThanTheBodiesBear)
{
    const scalar gap = 0.01, modulus = 50;
    const auto force = [&](const scalar speed, const std::string& pull)
    {
        rigidBodies world(approaching(gap, speed, 1e8, 720));
        contact law(film("cutOff 0.25; pull " + pull + ";"));
        world.advance(law, 1e-5);
        return std::make_pair(forceOn(world, 0).x(), world);
    };

    const scalar push = force(0.1, "0.1").first;
    EXPECT_NEAR(force(-0.1, "1e9").first/push, -1, 1e-3);
    EXPECT_LT(mag(force(-0.1, "0").first/push), 1e-6);

    const auto held = force(-0.1, "2");
    EXPECT_GT(held.first, 0.1*mag(push));
    EXPECT_LT(held.first, 0.9*mag(push));
    scalar largest = 0;
    forAll(held.second.force, i)
    {
        largest = max
        (
            largest,
            mag(held.second.force[i])/held.second.bodies.areas()[i]
        );
    }
    EXPECT_NEAR(largest/(2*modulus), 1, 0.06);
}


TEST(Lubrication, takesEnergyAndKeepsGapsOpenAtAnyTimeStep)
{
    for (const scalar dt : {0.01, 0.2})
    {
        for (const scalar speed : {0.4, -0.4})
        {
            rigidBodies world(approaching(0.1, speed, 0.2));
            world.solids[1].spin = vector(0, 0, 0.5);
            contact law(film("roughness 1e-3;"));
            scalar energy = world.kineticEnergy();
            const vector p(world.momentum());
            for (label i = 0; i*dt < 2; ++i)
            {
                world.advance(law, dt);
                EXPECT_LE(world.kineticEnergy(), energy*(1 + 1e-12));
                energy = world.kineticEnergy();
                ASSERT_GT(world.statistics.smallestGap, 0);
                EXPECT_LT(mag(world.momentum() - p), 1e-12);
            }
            if (speed < 0)
            {
                EXPECT_GT(gapOf(world), 0.1) << "they stick";
            }
        }
    }
}


TEST(Lubrication, stopsWhereTheImpulseSaysWhateverTheTimeStep)
{
    // Reduced mass times speed = impulse of the film between the two gaps
    const scalar mass = 0.5, speed = 0.1;
    scalar impulse = 0, gap = 0.1;
    while (impulse < mass/2*2*speed)
    {
        const scalar dg = 1e-3*gap;
        impulse += 6*viscosity*0.5*dg*filmIntegral(gap, 0.2, 0.5);
        gap -= dg;
    }
    for (const scalar dt : {0.02, 0.15})
    {
        rigidBodies world(approaching(0.1, speed, mass));
        contact law(film("roughness 1e-3;"));
        for (label i = 0; i*dt < 6; ++i)
        {
            world.advance(law, dt);
        }
        EXPECT_NEAR(gapOf(world)/gap, 1, 0.05) << dt;
    }
}


TEST(Lubrication, wallIsFlat)
{
    rigidBodies world;
    world.add(circleNodes(1, 720), {0, 1.01, 0}, {0, -0.1, 0}, 0, 1e8);
    world.walls.append(contactWall(Zero, vector(0, 1, 0)));
    contact law(film("cutOff 0.5;"));
    world.advance(law, 1e-5);

    // R is 1 instead of 1/2: x of the quadrature grows with sqrt(R)
    const scalar expected =
        6*viscosity*0.1*Foam::sqrt(2.0)*filmIntegral(0.01, 0.1, 0.5);
    EXPECT_NEAR(forceOn(world, 0).y()/expected, 1, 0.03);
}


TEST(Lubrication, refusesWhatItCannotDo)
{
    EXPECT_THROW
    (
        contact(dictOf("lubrication { type Reynolds; }"), 2, 0.2, 50),
        Foam::IOerror
    );
    EXPECT_NO_THROW
    (
        contact(dictOf("lubrication { type Reynolds; }"), 2, 0.2, 50, 1e-3)
    );
    EXPECT_THROW(film("cutOff 1.5;"), Foam::IOerror);
    EXPECT_THROW(film("roughness 1;"), Foam::IOerror);
    EXPECT_THROW(film("pull -1;"), Foam::IOerror);
    EXPECT_THROW(film("colour 1;"), Foam::IOerror);
    EXPECT_THROW
    (
        contact(dictOf("lubrication { type oil; }"), 2, 0.2, 50),
        Foam::IOerror
    );
    for (const word type : {"none", "thesis"})
    {
        EXPECT_THROW
        (
            contact
            (
                dictOf
                (
                    "law { type " + type + "; }"
                    "lubrication { type Reynolds; viscosity 1; }"
                ),
                2, 0.2, 50
            ),
            Foam::IOerror
        );
    }
}


// ************************************************************************* //
