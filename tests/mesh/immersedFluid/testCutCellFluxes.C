// SPDX-License-Identifier: GPL-3.0-or-later

// The flow through the open parts of cut cells' faces and the flow that their
// walls push must add up to nothing where the velocity is free of divergence
// and linear next to the wall, whatever the way the wall cuts the cells:
// (4.13), (5.2). Cells of size 1

#include <gtest/gtest.h>

#include "discSurfaces.H"
#include "faceVelocities.H"
#include "openfoamVersion.H"
#include "sphereSurfaces.H"
#include "surfacesInBox.H"
#include "wallOperator.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

constexpr scalar radius = 7.1;

//- A body in a box
surfacesInBox bodyInBox(const direction nDims, const direction split)
{
    return surfacesInBox
    (
        nDims == 2 ? labelVector(32, 20, 1) : labelVector(24, 20, 18),
        nDims,
        split
    );
}

//- Its centre
point centreOf(const direction nDims)
{
    return nDims == 2 ? point(15.7, 10.2, 0) : point(11.7, 10.2, 8.9);
}

surfaceSet bodyAt(const List<point>& centres, const direction nDims)
{
    return
        nDims == 2
      ? discSurfaces(centres, radius, 96)
      : sphereSurfaces(centres, radius, 4);
}

//- Velocity at a place relative to the body's centre
typedef vector (*flow)(const vector& r);

vector strain(const vector& r)
{
    return vector(r.x() + 0.5*r.y(), 0.5*r.x() - r.y(), 0);
}

vector strainInSpace(const vector& r)
{
    return vector
    (
        0.6*r.x() + 0.5*r.y() - 0.3*r.z(),
        0.5*r.x() - r.y() + 0.2*r.z(),
        -0.3*r.x() + 0.2*r.y() + 0.4*r.z()
    );
}

vector rotation(const vector& r)
{
    return vector(-r.y(), r.x(), 0);
}

vector rotationInSpace(const vector& r)
{
    return vector(0.6, -0.5, 0.6) ^ r;
}

vector none(const vector&)
{
    return vector(Zero);
}

//- Around the body, at rest on it
template<flow turning>
vector shear(const vector& r)
{
    return (1 - radius/mag(r))*turning(r);
}


//- Cells with a wall of the body
boolList cellsWithWalls(const surfacesInBox& body)
{
    boolList result(body.mesh().nCells(), false);
    for (const cellWall& w : body.geometry().surfaceParts())
    {
        result[w.cell] = true;
    }
    return result;
}


//- Largest sum of fluxes of a cell of the body's surroundings over the velocity
//  gradient, which is about 1
scalar largestSource
(
    const flow fluid,
    const flow wall,
    const direction nDims,
    const direction split
)
{
    surfacesInBox body(bodyInBox(nDims, split));
    const point centre(centreOf(nDims));
    body.move(bodyAt(List<point>({centre}), nDims));
    const fvMesh& mesh = body.mesh();
    volVectorField U
    (
        IOobject("U", nameOf(mesh.time()), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero)
    );
    forAll(U, celli)
    {
        vector r(mesh.C()[celli] - centre);
        r.z() = nDims == 2 ? 0 : r.z();
        U[celli] = fluid(r);
    }
    U.correctBoundaryConditions();
    vectorField v(body.surfaces().points().size());
    forAll(v, nodei)
    {
        v[nodei] = wall(body.surfaces().points()[nodei] - centre);
    }

    const surfaceScalarField velocity
    (
        faceVelocities(body.geometry()).velocity({U, v, nullptr, 0})
    );
    wallOperator walls(body.geometry());
    walls.update(body.surfaces());
    scalarField source(walls.cells().size(), Zero);
    walls.addGrossFluxAtWalls(v, source);
    const boolList besideBody(cellsWithWalls(body));
    scalar largest = 0;
    forAll(source, i)
    {
        const label celli = walls.cells()[i];
        for (const label facei : mesh.cells()[celli])
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            const label start =
                patchi < 0 ? 0 : mesh.boundaryMesh()[patchi].start();
            const scalar open = body.geometry().openness()[facei];
            if (patchi < 0 || mesh.boundaryMesh()[patchi].coupled())
            {
                const scalar flux =
                    patchi < 0
                  ? velocity[facei]
                  : velocity.boundaryField()[patchi][facei - start];
                source[i] +=
                    (mesh.faceOwner()[facei] == celli ? flux : -flux)
                   *open*body.grid().faceArea();
            }
        }
        if (besideBody[celli])
        {
            largest = max(largest, mag(source[i])/body.grid().faceArea());
        }
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
        EXPECT_LT(largestSource(strain, strain, 2, split), 0.05);
        EXPECT_LT(largestSource(rotation, rotation, 2, split), 0.05);
    }
}


TEST(cutCellFluxes, ofAShearFlowAlongAWallAddUpToNothing)
{
    // With the velocity in the middle of each face for all of it: 0.11
    for (direction split = 0; split < 2; ++split)
    {
        EXPECT_LT(largestSource(shear<rotation>, none, 2, split), 0.04);
    }
}


TEST(cutCellFluxes, inSpace)
{
    for (direction split = 0; split < 3; ++split)
    {
        const flow along = shear<rotationInSpace>;
        EXPECT_LT(largestSource(along, none, 3, split), 0.05);

        // Not as good as in a plane: the mean of the places where the surface
        // cuts the faces is not the centroid of the piece in the cell, nor is
        // the middle of an open part moved in both directions of its face
        const flow turning = rotationInSpace;
        EXPECT_LT(largestSource(turning, turning, 3, split), 0.5);
        const flow straining = strainInSpace;
        EXPECT_LT(largestSource(straining, straining, 3, split), 0.5);
    }
}


// ************************************************************************* //
