// SPDX-License-Identifier: GPL-3.0-or-later

// Films between rigid bodies that touch

#include "rigidSpheres.H"

namespace
{

const scalar pi = constant::mathematical::pi;
const scalar h = 0.2;
const scalar touching = 0.1*h;
const scalar roughness = 1e-3;

contact contactOf(const direction nDims, const scalar e)
{
    return contact
    (
        textDict
        (
            "roughness " + std::to_string(roughness) + "; law { restitution "
          + std::to_string(e) + "; }"
        ),
        nDims,
        h,
        0
    );
}


contactFilm filmOf(const scalar viscosity)
{
    contactFilm film;
    film.viscosity = viscosity;
    film.roughness = roughness;
    return film;
}


//- A body of radius and mass 1 that meets a wall at x = 2 with the speed 0.5
rigidBodies atWall(const direction nDims, const scalar viscosity)
{
    rigidBodies world(nDims);
    const vector speed(0.5, 0, 0);
    if (nDims == 2)
    {
        world.add(circleNodes(1, 96), Zero, speed);
    }
    else
    {
        add(world, sphereAtOrigin(1, 4), Zero, speed);
    }
    world.walls.append(contactWall({2, 0, 0}, {-1, 0, 0}));
    world.film.viscosity = viscosity;
    return world;
}


//- Speed of the first body after the collision; > 0 is away
scalar after(rigidBodies& world, const scalar e, const scalar dt = 0.02)
{
    contact law(contactOf(world.surfaces.nDims(), e));
    for (label i = 0; i*dt < 3.5; ++i)
    {
        world.advance(law, dt);
    }
    return -world.solids[0].velocity.x();
}


//- Impulse of the film of a body of radius 1 and a wall, per viscosity
scalar exactImpulse(const direction nDims)
{
    return
        nDims == 2
      ? 6*std::sqrt(2.0)*pi*(1/std::sqrt(roughness) - 1/std::sqrt(touching))
      : 6*pi*std::log(touching/roughness);
}

} // End anonymous namespace


TEST(ContactFilm, impulseIsTheIntegralOfTheResistance)
{
    const contactFilm film(filmOf(0.3));
    const scalar radius = 1.7;
    for (const direction nDims : {2, 3})
    {
        // Over the logarithm of the gap, by Simpson's rule
        const label n = 2000;
        const scalar step = std::log(touching/roughness)/n;
        scalar sum = 0;
        for (label i = 0; i <= n; ++i)
        {
            const scalar g = roughness*std::exp(i*step);
            const scalar resistance =
                nDims == 2
              ? 3*std::sqrt(2.0)*pi*0.3*std::pow(radius/g, 1.5)
              : 6*pi*0.3*sqr(radius)/g;
            const scalar weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
            sum += weight*step/3*resistance*g;
        }
        const scalar found = film.impulse(radius, touching, nDims);
        EXPECT_NEAR(found, sum, 1e-10*sum);
    }
    EXPECT_EQ(film.impulse(radius, roughness, 3), 0);
    EXPECT_EQ(contactFilm().impulse(radius, touching, 3), 0);
}


TEST(ContactFilm, radiusFollowsFromTheSurface)
{
    // The cap of a sphere exactly, a circle in the limit. The gaps start where
    // the lowest place is, or a tenth of the depth above it
    const contactFilm film(filmOf(1));
    const scalar depth = 1e-4, radius = 1.7;
    for (const scalar above : {0.0, 0.1*depth})
    {
        const label n = 20000;
        scalar cap[2] = {0, 0}, arc[2] = {0, 0};
        for (label i = 0; i < n; ++i)
        {
            const scalar z = (i + 0.5)/n*(depth + above);
            const scalar part = 1 - (z - above)/depth;
            const scalar ring = 2*pi*radius*(depth + above)/n;
            const scalar angle =
                (i + 0.5)/n*std::acos(1 - (depth + above)/radius);
            const scalar arcPart =
                1 - (radius*(1 - std::cos(angle)) - above)/depth;
            const scalar piece =
                2*radius*std::acos(1 - (depth + above)/radius)/n;
            for (const label k : {0, 1})
            {
                cap[k] += ring*std::pow(part, 2 + k);
                arc[k] += piece*std::pow(arcPart, 2 + k);
            }
        }
        EXPECT_NEAR(film.radius(cap[0], cap[1], depth, 3), radius, 1e-6);
        EXPECT_NEAR(film.radius(arc[0], arc[1], depth, 2), radius, 1e-4);
    }
}


TEST(ContactFilm, takesItsImpulseBeforeAndAfterTheTouch)
{
    for (const direction nDims : {2, 3})
    {
        for (const scalar e : {1.0, 0.8})
        {
            for (const scalar loss : {0.02, 0.1, 0.2})
            {
                const scalar viscosity = loss/exactImpulse(nDims);
                const scalar expected = e*(0.5 - loss) - loss;
                for (const scalar dt : {0.01, 0.04})
                {
                    rigidBodies world(atWall(nDims, viscosity));
                    const scalar found = after(world, e, dt);
                    EXPECT_NEAR(found, expected, 0.1*loss)
                        << label(nDims) << " dimensions, restitution " << e
                        << ", loss " << loss << ", step " << dt;
                }
            }

            // All of it: the body stays where it touches
            rigidBodies world(atWall(nDims, 0.26/exactImpulse(nDims)));
            EXPECT_NEAR(after(world, e), 0, 1e-12);
            EXPECT_NEAR(world.statistics.smallestGap, touching, 1e-3*h);
        }
    }
}


TEST(ContactFilm, twoBodiesShareIt)
{
    // R = 1/2, and the mass of one that responds is 1/2 as well
    const scalar loss = 0.1;
    const scalar viscosity = 0.5*loss/(0.25*exactImpulse(3));
    for (const scalar added : {0.0, 0.5})
    {
        rigidBodies world(3);
        const surfaceSet sphere(sphereAtOrigin(1, 4));
        add(world, sphere, {-1.5, 0, 0}, {0.5, 0, 0});
        add(world, sphere, {1.5, 0, 0}, {-0.5, 0, 0});
        world.film.viscosity = viscosity;
        world.addedMass = added;
        after(world, 1);
        const scalar parts =
            world.solids[1].velocity.x() - world.solids[0].velocity.x();
        EXPECT_NEAR(parts, 1 - 2*loss/(1 + added), 0.1*loss);
        EXPECT_LT(mag(world.momentum()), 1e-12);
        EXPECT_LT(mag(world.angularMomentum()), 1e-12);
    }
}


TEST(ContactFilm, nothingWithoutAFluid)
{
    for (const direction nDims : {2, 3})
    {
        rigidBodies with(atWall(nDims, 0));
        rigidBodies without(atWall(nDims, 0.1));
        contact plain(textDict("law { restitution 0.8; }"), nDims, h, 0);
        contact rough(contactOf(nDims, 0.8));
        for (label i = 0; i < 200; ++i)
        {
            with.advance(rough, 0.02);
            without.advance(plain, 0.02);
            ASSERT_EQ(with.solids[0].centre, without.solids[0].centre);
        }
        EXPECT_LT(with.solids[0].velocity.x(), -0.3);
    }
}


TEST(ContactFilm, fluidThatMovesWithABody)
{
    EXPECT_NEAR(contactFilm::addedMass(3), 0.8031, 1e-4);
    EXPECT_NEAR(contactFilm::addedMass(2), 2.2899, 1e-4);
}


TEST(ContactFilm, badEntries)
{
    const auto made = [](const std::string& text)
    {
        contact(textDict(text), 2, h, 0);
    };
    EXPECT_NO_THROW(made("roughness 1e-3;"));
    for (const char* bad : {"0", "-1e-3", "0.03", "smooth"})
    {
        EXPECT_THROW(made("roughness " + word(bad) + ";"), IOerror) << bad;
    }
    EXPECT_NO_THROW(made("roughness 1e-3; law { type elastic; stiffness 1; }"));
    EXPECT_THROW(made("roughness 1e-3; law { type none; }"), IOerror);
}
