// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "discSurfaces.H"
#include "domainSides.H"
#include "interfaceGeometry.H"
#include "levelSetUpdate.H"
#include "syncTools.H"
#include "wallOperator.H"
#include "wallTreatment.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- A square of 16 cells of size 1, cyclic in both directions
boxLayout cyclicSquare(const direction split)
{
    boxLayout layout;
    layout.cyclic[0] = true;
    layout.cyclic[1] = true;
    layout.splitDirection = split;
    return layout;
}


//- A disc of radius 3.3 that moves with velocity (1 2 0)
surfaceSet disc(const point& centre)
{
    surfaceSet surfaces(discSurfaces(pointField(1, centre), 3.3, 32));
    surfaces.velocities() = vector(1, 2, 0);
    return surfaces;
}


//- Traces of a disc in the mesh
struct wallSums
{
    label nFaces = 0;
    label nLinks = 0;
    label nFluid = 0;
    scalar area = 0;
    scalar conductance = 0;
    vectorField force;
    scalar flux = 0;
};


//- Expect both sides of each coupled patch to see the same
void expectSameAcross(const fvMesh& mesh, const scalarField& openness)
{
    scalarField across
    (
        SubList<scalar>
        (
            openness,
            mesh.nFaces() - mesh.nInternalFaces(),
            mesh.nInternalFaces()
        )
    );
    const scalarField here(across);
    syncTools::swapBoundaryFaceList(mesh, across);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            const label facei = patch.start() - mesh.nInternalFaces() + i;
            EXPECT_EQ(here[facei], across[facei]);
        }
    }
}


//- Sums over the walls of a disc
wallSums sumsOf(const point& centre, const direction split)
{
    boxMesh box(labelVector(16, 16, 1), 2, cyclicSquare(split));
    const cartesianMesh grid(box.mesh());
    periodicImages images(domainSides(box.mesh()).images());
    const surfaceSet surfaces(disc(centre));
    const autoPtr<wallTreatment> wall(wallTreatment::New(dictionary()));
    autoPtr<levelSetUpdate> levelSet
    (
        levelSetUpdate::New(grid, dictionary())
    );
    const surfaceSet& all = images.update(surfaces, 5);
    levelSet->initialise(all);
    interfaceGeometry geometry(grid, *wall);
    geometry.update(*levelSet, all);

    expectSameAcross(box.mesh(), geometry.openness());

    wallSums sums;
    for (const wallFace& w : geometry.wallFaces())
    {
        // A face between ranks, or of a cyclic patch, is there twice
        EXPECT_EQ(w.place.object, 0);
        for (const label nodei : w.place.nodes)
        {
            EXPECT_LT(nodei, surfaces.points().size());
        }
        sums.area += w.area*(label(w.lower >= 0) + label(w.upper >= 0));
    }
    for (const wallLink& link : geometry.wallLinks())
    {
        ++sums.nLinks;
        sums.conductance += link.conductance;
    }
    for (const bool fluid : geometry.fluidCell())
    {
        sums.nFluid += fluid;
    }
    reduce(sums.area, sumOp<scalar>());
    reduce(sums.nLinks, sumOp<label>());
    reduce(sums.conductance, sumOp<scalar>());
    reduce(sums.nFluid, sumOp<label>());

    wallOperator walls(geometry);
    walls.update(surfaces);
    sums.force = walls.uniformForce();
    scalarField Jv(box.mesh().nCells());
    walls.flux(surfaces.velocities(), Jv);
    sums.flux = gSum(mag(Jv));
    EXPECT_NEAR(gSum(Jv), 0, 1e-10);
    return sums;
}

} // End anonymous namespace


TEST(periodic, meshKnowsItsPeriods)
{
    boxLayout layout;
    layout.cyclic[0] = true;
    layout.splitDirection = 1;
    boxMesh box(labelVector(8, 6, 1), 2, layout);
    const cartesianMesh grid(box.mesh());
    EXPECT_EQ(grid.period(), vector(8, 0, 0));

    const label celli = grid.findCell(point(0.5, 1.5, 0));
    EXPECT_EQ(grid.findCell(point(8.5, 1.5, 0)), celli);
    EXPECT_EQ(grid.findCell(point(-7.5, 1.5, 0)), celli);
    EXPECT_EQ(grid.findCell(point(0.5, 7.5, 0)), -1);
    EXPECT_EQ(returnReduce(label(celli >= 0), sumOp<label>()), 1);

    const domainSides sides(box.mesh());
    EXPECT_EQ(sides[0], domainSides::CYCLIC);
    EXPECT_EQ(sides[1], domainSides::CYCLIC);
    EXPECT_EQ(sides[2], domainSides::WALL);
    EXPECT_EQ(sides[3], domainSides::WALL);
    EXPECT_EQ(sides.walls().size(), 2);
    EXPECT_FALSE(sides.anyOpen());
}


TEST(periodic, wallsAreTheSameAcrossASeam)
{
    for (const direction split : {0, 1})
    {
        const point inside(7.3, 8.1, 0);
        const wallSums expected(sumsOf(inside, split));
        EXPECT_GT(expected.nLinks, 20);
        for (const vector& shift : {vector(8, 0, 0), vector(-7, 8, 0)})
        {
            const wallSums found(sumsOf(inside + shift, split));
            EXPECT_EQ(found.nLinks, expected.nLinks);
            EXPECT_EQ(found.nFluid, expected.nFluid);
            EXPECT_NEAR(found.area, expected.area, 1e-10);
            EXPECT_NEAR(found.conductance, expected.conductance, 1e-9);
            EXPECT_NEAR(found.flux, expected.flux, 1e-9);
            ASSERT_EQ(found.force.size(), expected.force.size());
            EXPECT_LT(max(mag(found.force - expected.force)), 1e-10);
        }
    }
}


// ************************************************************************* //
