// SPDX-License-Identifier: GPL-3.0-or-later

// What flows through the open parts of cut cells' faces and what their walls
// push must add up to nothing where the velocity is free of divergence and
// linear next to the wall, whatever the way the wall cuts the cells: (4.13),
// (5.2). Cells of size 1

#include <gtest/gtest.h>

#include "discsInBox.H"
#include "faceVelocities.H"
#include "wallOperator.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const point centre(15.7, 10.2, 0);

//- Velocity at a place relative to the disc's centre
typedef vector (*flow)(const vector& r);

vector strain(const vector& r)
{
    return vector(r.x() + 0.5*r.y(), 0.5*r.x() - r.y(), 0);
}

vector rotation(const vector& r)
{
    return vector(-r.y(), r.x(), 0);
}

vector none(const vector&)
{
    return vector(Zero);
}

//- Around the disc, at rest on it
vector shear(const vector& r)
{
    return (1 - discsInBox::radius/mag(r))*rotation(r);
}


//- Largest sum of fluxes of a cell of the disc's surroundings over the velocity
//  gradient, which is about 1
scalar largestSource(const flow fluid, const flow wall, const direction split)
{
    discsInBox disc(split);
    disc.move({centre});
    const fvMesh& mesh = disc.mesh();
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero)
    );
    forAll(U, celli)
    {
        vector r(mesh.C()[celli] - centre);
        r.z() = 0;
        U[celli] = fluid(r);
    }
    U.correctBoundaryConditions();
    vectorField v(disc.surfaces().points().size());
    forAll(v, nodei)
    {
        v[nodei] = wall(disc.surfaces().points()[nodei] - centre);
    }

    const surfaceScalarField velocity
    (
        faceVelocities(disc.geometry()).velocity({U, v, nullptr, 0})
    );
    wallOperator walls(disc.geometry());
    walls.update(disc.surfaces());
    scalarField source(walls.cells().size(), Zero);
    walls.addGrossFluxAtWalls(v, source);
    scalar largest = 0;
    forAll(source, i)
    {
        const label celli = walls.cells()[i];
        for (const label facei : mesh.cells()[celli])
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            const label start =
                patchi < 0 ? 0 : mesh.boundaryMesh()[patchi].start();
            const scalar open = disc.geometry().openness()[facei];
            if (patchi < 0 || mesh.boundaryMesh()[patchi].coupled())
            {
                const scalar flux =
                    patchi < 0
                  ? velocity[facei]
                  : velocity.boundaryField()[patchi][facei - start];
                source[i] +=
                    (mesh.faceOwner()[facei] == celli ? flux : -flux)
                   *open*disc.grid().faceArea();
            }
        }
        largest = max(largest, mag(source[i])/disc.grid().faceArea());
    }
    return returnReduce(largest, maxOp<scalar>());
}

} // End anonymous namespace


TEST(cutCellFluxes, ofALinearVelocityAddUpToNothing)
{
    // With a velocity for each wall face and those of the middles of open
    // ones: 1.35 for the strain, 0.26 for the rotation
    for (direction split = 0; split < 2; ++split)
    {
        EXPECT_LT(largestSource(strain, strain, split), 0.05);
        EXPECT_LT(largestSource(rotation, rotation, split), 0.05);
    }
}


TEST(cutCellFluxes, ofAShearFlowAlongAWallAddUpToNothing)
{
    // With the velocity in the middle of each face for all of it: 0.11
    for (direction split = 0; split < 2; ++split)
    {
        EXPECT_LT(largestSource(shear, none, split), 0.04);
    }
}


// ************************************************************************* //
