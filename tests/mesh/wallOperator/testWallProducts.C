// SPDX-License-Identifier: GPL-3.0-or-later

// Products of walls and links with the objects' nodes, and the gradient beside
// them, on cells of size 1

#include <gtest/gtest.h>

#include "immersedGradient.H"
#include "linkOperator.H"
#include "openfoamVersion.H"
#include "momentum/twoBodies.H"
#include "wallOperator.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- p.q over all ranks
scalar product(const scalarField& p, const scalarField& q)
{
    return gSum(scalarField(p*q));
}

} // End anonymous namespace


TEST(wallOperator, isTheTransposeOfItsTranspose)
{
    forBoxes([](const direction nDims, const direction split)
    {
        twoBodies bodies(nDims, split);
        wallOperator walls(bodies.geometry());
        walls.update(bodies.surfaces());

        scalarField Jv(bodies.p.size());
        vectorField f;
        walls.flux(bodies.v, Jv);
        walls.transpose(bodies.p, f);
        const scalar work = sum(f & bodies.v);
        EXPECT_GT(mag(work), 0.1);
        EXPECT_NEAR(product(bodies.p, Jv), work, 1e-12);

        // Objects of constant volume: no net flux, no force of a level
        EXPECT_NEAR(gSum(Jv), 0, 1e-12);
        walls.transpose(scalarField(bodies.p.size(), 1), f);
        EXPECT_NEAR(max(mag(f)), 0, 1e-12);
    });
}


TEST(wallOperator, sameAtWalls)
{
    twoBodies bodies(3, 0);
    wallOperator walls(bodies.geometry());
    walls.update(bodies.surfaces());
    const labelUList& cells = walls.cells();
    EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));

    scalarField Jv(bodies.p.size());
    scalarField Jw(cells.size(), Zero);
    walls.flux(bodies.v, Jv);
    walls.addFluxAtWalls(bodies.v, Jw);
    forAll(cells, i)
    {
        EXPECT_EQ(Jv[cells[i]], Jw[i]);
        Jv[cells[i]] = 0;
    }
    EXPECT_EQ(gMax(mag(Jv)()), 0);

    vectorField f, fw;
    walls.transpose(bodies.p, f);
    walls.transposeAtWalls(walls.atWalls(bodies.p), fw);
    EXPECT_EQ(f, fw);
}


// Two bodies, links' viscosity and fluid's density, a matrix of a diagonal
struct linkedBodies
:
    twoBodies
{
    const scalar viscosity = 0.3;
    const scalar density = 7;
    redBlackMatrix matrix;
    linkOperator operation;
    scalarField diagonal;
    vectorField source;

    linkedBodies(const direction nDims, const direction split)
    :
        twoBodies(nDims, split),
        matrix(grid()),
        operation(matrix, nDims),
        diagonal(U.size(), 2),
        source(U.size(), vector(3, 4, nDims == 2 ? 0 : 5))
    {
        fvVectorMatrix equation(U, dimVolume*dimAcceleration);
        equation.diag() = 2;
        equation.upper() = 0;
        equation.source() = source;
        for (label step = 0; step < 2; ++step)
        {
            matrix.set(equation);
            operation.set(geometry().wallLinks(), viscosity);
        }
        for (const wallLink& link : geometry().wallLinks())
        {
            diagonal[link.cell] += viscosity*link.conductance;
        }
    }

    //- Add sources of walls that move with a velocity, link by link
    void addSources(const vectorField& velocity)
    {
        for (const wallLink& link : geometry().wallLinks())
        {
            source[link.cell] +=
                viscosity*link.conductance*link.place.interpolate(velocity);
        }
    }

    //- Forces of the velocities U, link by link and by the operator
    void expectForces(const scalar tolerance)
    {
        vectorField force(v.size(), Zero);
        for (const wallLink& link : geometry().wallLinks())
        {
            link.place.spread
            (
                force,
                density*viscosity*link.conductance*U[link.cell]
            );
        }
        partialForces found(v.size());
        operation.addForce(density, found);
        EXPECT_LT(max(mag(found.mine() - force)), tolerance);
        EXPECT_GT(gMax(mag(force)()), 0.1);
    }
};


TEST(linkOperator, sumsTheLinks)
{
    forBoxes([](const direction nDims, const direction split)
    {
        linkedBodies bodies(nDims, split);
        bodies.addSources(bodies.v);
        bodies.operation.setSources(bodies.v);
        forAll(bodies.source, celli)
        {
            const scalar* found =
                bodies.matrix.source(bodies.matrix.row(celli));
            for (direction d = 0; d < nDims; ++d)
            {
                EXPECT_NEAR(found[d], bodies.source[celli][d], 1e-13) << celli;
            }
        }
        bodies.expectForces(1e-12);
    });
}


TEST(linkOperator, correctsTheLinks)
{
    forBoxes([](const direction nDims, const direction split)
    {
        linkedBodies bodies(nDims, split);
        redBlackMatrix& matrix = bodies.matrix;
        bodies.operation.setSources(bodies.v);
        const scalar norm = matrix.sourceNorm();
        matrix.startCorrection(norm);
        bodies.operation.startCorrection(bodies.v);

        // Residuals with other velocities of the nodes
        const vectorField later(2*bodies.v + vector(0.3, -0.4, 0));
        bodies.addSources(later);
        bodies.operation.setResiduals(later);
        forAll(bodies.source, celli)
        {
            const vector expected
            (
                bodies.source[celli] - bodies.diagonal[celli]*bodies.U[celli]
            );
            const floatScalar* found = matrix.residual(matrix.row(celli));
            for (direction d = 0; d < nDims; ++d)
            {
                EXPECT_NEAR(found[d], expected[d]/norm, 1e-6) << celli;
            }
        }

        // Forces of the corrected velocities, which the diagonal alone gives
        EXPECT_GT(matrix.sweep(1), 0.01);
        vectorField corrected(bodies.U.size(), Zero);
        matrix.addTo
        (
            boolList(corrected.size(), true), corrected, 0, corrected
        );
        bodies.U.primitiveFieldRef() = corrected;
        bodies.expectForces(1e-10);
        forAll(corrected, celli)
        {
            const vector expected(bodies.source[celli]/bodies.diagonal[celli]);
            EXPECT_LT(mag(corrected[celli] - expected), 2e-5) << celli;
        }
    });
}


TEST(immersedGradient, gradientOfALinearPressure)
{
    forBoxes([](const direction nDims, const direction split)
    {
        twoBodies bodies(nDims, split);
        const vector slope(2, -3, nDims == 2 ? 0 : 1);
        const fvMesh& mesh = bodies.mesh();
        volScalarField p
        (
            IOobject("p", nameOf(mesh.time()), mesh),
            mesh,
            dimensionedScalar(dimless, Zero),
            "zeroGradient"
        );
        p.primitiveFieldRef() = slope & mesh.C().primitiveField();
        p.correctBoundaryConditions();
        const immersedGradient fluid(bodies.geometry());
        const volVectorField gradient(fluid.gradient(p));

        // Fluid cells, and solid ones beside them, have it; others have none
        const boolList& isFluid = bodies.geometry().fluidCell();
        label nBeside = 0;
        forAll(gradient, celli)
        {
            const scalar size = mag(gradient[celli]);
            if (isFluid[celli] || size > 0)
            {
                EXPECT_LT(mag(gradient[celli] - slope), 1e-10)
                    << mesh.C()[celli].x() << ' ' << mesh.C()[celli].y();
                nBeside += !isFluid[celli];
            }
        }
        EXPECT_GT(returnReduce(nBeside, sumOp<label>()), 60);
    });
}


// ************************************************************************* //
