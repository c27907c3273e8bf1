// SPDX-License-Identifier: GPL-3.0-or-later

// A sphere in a box, about which the fluid moves with a velocity that grows
// linearly with the distance from the wall

#include <gtest/gtest.h>

#include "faceLattice.H"
#include "openfoamMesh.H"
#include "sphereSurfaces.H"
#include "sumOverRanks.H"
#include "surfacesInBox.H"
#include "wallGhosts.H"

#include <random>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const point centre(8.3, 7.9, 8.1);
const scalar radius = 5;

//- Velocity of the wall
const vector ofWall(0.3, -0.2, 0.1);

//- Its increase per distance from the wall
const vector slope(1, 2, -0.5);


struct sphereInBox
{
    surfacesInBox box;
    wallGhosts ghosts;
    volVectorField U;

    explicit sphereInBox(const direction split)
    :
        box(labelVector(16, 16, 16), 3, split),
        ghosts(box.geometry(), box.levelSet()),
        U
        (
            IOobject("U", nameOf(box.mesh().time()), box.mesh()),
            box.mesh(),
            dimensionedVector(dimVelocity, Zero),
            word("zeroGradient")
        )
    {
        box.move(sphereSurfaces(List<point>(1, centre), radius, 4));
        ghosts.update();
        const boolList& fluid = box.geometry().fluidCell();
        forAll(U, celli)
        {
            const scalar d = mag(box.mesh().C()[celli] - centre) - radius;
            U[celli] = ofWall + (fluid[celli] ? d*slope : vector(Zero));
        }
        U.correctBoundaryConditions();
    }

    //- Values of the faces, with all faces closed: means of the cells
    void setFaces(const faceLattice& faces, faceLattice::faceArrays& u) const
    {
        const surfaceScalarField zero
        (
            IOobject("f", nameOf(box.mesh().time()), box.mesh()),
            box.mesh(),
            dimensionedScalar(dimVelocity*dimArea, Zero)
        );
        faces.setVelocities(zero, zero, U, u);
    }
};


//- Places outside the sphere at this distance from its wall, the same on all
//  ranks
pointField places(const scalar distance)
{
    std::mt19937 random(1);
    std::normal_distribution<scalar> some;
    pointField result(40);
    for (point& p : result)
    {
        const vector along(some(random), some(random), some(random));
        p = centre + (radius + distance)/mag(along)*along;
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallGhosts, letNodesMoveAsTheFluidDoesBesideAWall)
{
    for (direction split = 0; split < 3; ++split)
    {
        sphereInBox sphere(split);
        sphere.ghosts.extend(sphere.U);
        const faceLattice faces(sphere.box.grid());
        faceLattice::faceArrays u;
        sphere.setFaces(faces, u);
        for (const scalar distance : {0.01, 0.25, 0.5, 1.0})
        {
            const pointField x(places(distance));
            for (const label width : {2, 3})
            {
                vectorField v(x.size());
                staggeredTransfer(faces.lattice(), width).interpolate(x, u, v);
                sumOverRanks(v);
                scalar worst = 0;
                forAll(v, i)
                {
                    const vector d(v[i] - ofWall - distance*slope);
                    worst = max(worst, mag(d)/mag(slope));
                }
                EXPECT_LT(worst, 0.15) << width << " points, " << distance;
            }
        }
    }
}


TEST(wallGhosts, bringForcesBackByTheTranspose)
{
    for (direction split = 0; split < 3; ++split)
    {
        sphereInBox sphere(split);
        const fvMesh& mesh = sphere.box.mesh();
        vectorField force(mesh.nCells());
        vectorField nodal(sphere.box.surfaces().points().size(), Zero);
        vector all(Zero);
        const auto some = [](const point& x)
        {
            return vector(std::sin(3*x.x()), std::cos(5*x.y()), x.z() - 8);
        };
        forAll(force, celli)
        {
            const point& x = mesh.C()[celli];
            const bool near = mag(mag(x - centre) - radius) < 2;
            force[celli] = near ? some(x) : vector(Zero);
            all += force[celli];
        }
        const vectorField before(force);
        const vectorField u(sphere.U.primitiveField());
        sphere.ghosts.extend(sphere.U);
        scalar work = 0;
        forAll(force, celli)
        {
            work += before[celli] & sphere.U[celli];
        }
        sphere.ghosts.bringBack(sphere.box.surfaces(), force, nodal);
        forAll(force, celli)
        {
            work -= force[celli] & u[celli];
            all -= force[celli];
        }
        for (const vector& f : nodal)
        {
            work -= f & ofWall;
            all -= f;
        }
        List<vector> sums(2, all);
        sums[1] = vector(work, 0, 0);
        sumOverRanks(sums);
        EXPECT_NEAR(mag(sums[0]), 0, 1e-10);
        EXPECT_NEAR(sums[1].x(), 0, 1e-10);
    }
}


// ************************************************************************* //
