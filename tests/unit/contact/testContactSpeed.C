// SPDX-License-Identifier: GPL-3.0-or-later

// Time of a step's contact among many soft spheres

#include "rigidSpheres.H"
#include "randomNumbers.H"

#include <ctime>

namespace
{

//- Spheres of radius 1 that fill 40 % of the space, on a lattice of densest
//  packing and thrown about a little; each gives way where it is pushed
struct manySpheres
{
    surfaceSet surfaces;
    contactBodies bodies;
    Eigen::MatrixXd inverse;
    List<contactWall> walls;
    vectorField force;

    manySpheres(const label n, const label nCuts)
    :
        surfaces(3)
    {
        const surfaceSet sphere(sphereAtOrigin(1, nCuts));
        const pointField& x = sphere.points();
        const scalar side =
            std::cbrt(4*4*constant::mathematical::pi/3/0.4);
        const vector corners[4] =
            {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
        randomNumbers random(6);
        const label perSide = std::ceil(std::cbrt(n/4.0));
        for (label i = 0; i < n; ++i)
        {
            const label c = i/4;
            const vector cell
            (
                c % perSide, (c/perSide) % perSide, c/(perSide*perSide)
            );
            const vector thrown(random.sample01<vector>());
            surfaces.append
            (
                x + side*(cell + corners[i % 4]) + 0.3*thrown,
                sphere.faces()
            );
        }
        for (vector& v : surfaces.velocities())
        {
            v = random.sample01<vector>() - vector::uniform(0.5);
        }

        inverse.resize(x.size(), x.size());
        forAll(x, i)
        {
            forAll(x, j)
            {
                inverse(i, j) = x.size()*std::exp(-mag(x[i] - x[j])/0.1);
            }
        }
        bodies.reset(surfaces);
        const scalarField areas
        (
            contactBodies::nodeAreas(x, sphere.faces(), 3, 1)
        );
        for (label i = 0; i < n; ++i)
        {
            bodies.setInverse(i, &inverse);
            SubList<scalar>
            (
                bodies.areas(), x.size(), surfaces.pointStart()[i]
            ) = areas;
        }
    }

    //- Seconds of the search and of all else
    std::pair<scalar, scalar> step(contact& law, const scalar dt)
    {
        const clock_t start = ::clock();
        const UList<medialAxisPoint> axis;
        law.measure(surfaces, bodies, walls, axis);
        const clock_t found = ::clock();
        const label sweeps = law.calculate
        (
            surfaces, surfaces.velocities(), bodies, walls, axis,
            contactStep(dt), force
        ).sweeps;
        const clock_t end = ::clock();
        std::cout
            << surfaces.size() << " spheres of "
            << surfaces.pointStart()[1] << " nodes, "
            << law.found().pairs.size() << " pairs, "
            << law.statistics().contacts << " contacts, " << sweeps
            << " sweeps: search " << scalar(found - start)/CLOCKS_PER_SEC
            << " s, solver " << scalar(end - found)/CLOCKS_PER_SEC << " s"
            << std::endl;
        return
        {
            scalar(found - start)/CLOCKS_PER_SEC,
            scalar(end - found)/CLOCKS_PER_SEC
        };
    }
};


//- Least seconds of some steps
std::pair<scalar, scalar> seconds(const label n, const label nCuts)
{
    // Cells a third longer than the nodes are apart
    const scalar h = Foam::sqrt(24.0/Foam::pow(4.0, nCuts + 1));
    manySpheres world(n, nCuts);
    std::pair<scalar, scalar> least(GREAT, GREAT);
    contact law(dictionary(), 3, h, 1);
    for (label i = 0; i < 3; ++i)
    {
        const scalar dt = 0.1*h;
        const auto now = world.step(law, dt);
        least.first = min(least.first, now.first);
        least.second = min(least.second, now.second);
        world.surfaces.points() += 0.1*dt*world.surfaces.velocities();
    }
    return least;
}

} // End anonymous namespace


TEST(ContactSpeed, isLinearInTheNumberOfSpheres)
{
    const auto few = seconds(32, 3);
    const auto many = seconds(256, 3);

    // 8 times the spheres, of which more have neighbours on all sides; n^2
    // would be 64
    EXPECT_LT(many.first, 20*few.first);
    EXPECT_LT(many.second, 24*few.second);
}


// ************************************************************************* //
