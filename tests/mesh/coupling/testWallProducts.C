// SPDX-License-Identifier: GPL-3.0-or-later

// Products of walls and links with the objects' nodes, and the gradient beside
// them, on cells of size 1

#include <gtest/gtest.h>

#include "discsInBox.H"
#include "immersedFluid.H"
#include "linkOperator.H"
#include "wallOperator.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Any value between -1 and 1, the same on all ranks
scalar any(const point& p)
{
    return std::sin(17*p.x() + 29*p.y() + 3);
}


//- Two discs less than two cells apart, and values of cells and nodes
class twoDiscs
:
    public discsInBox
{
public:

    scalarField p;
    volVectorField U;
    vectorField v;

    explicit twoDiscs(const direction split)
    :
        discsInBox(split),
        p(mesh().nCells()),
        U
        (
            IOobject("U", mesh().time().timeName(), mesh()),
            mesh(),
            dimensionedVector(dimVelocity, Zero)
        )
    {
        move({point(8.3, 10.2, 0), point(23.9, 9.7, 0)});
        forAll(p, celli)
        {
            const point& c = mesh().C()[celli];
            p[celli] = any(c);
            U[celli] = vector(any(2*c), any(3*c), 0);
        }
        v.setSize(surfaces().points().size());
        forAll(v, nodei)
        {
            const point& x = surfaces().points()[nodei];
            v[nodei] = vector(any(x), any(2*x), 0);
        }
    }
};


//- p.q over all ranks
scalar product(const scalarField& p, const scalarField& q)
{
    return gSum(scalarField(p*q));
}

} // End anonymous namespace


TEST(wallOperator, isTheTransposeOfItsTranspose)
{
    for (direction split = 0; split < 2; ++split)
    {
        twoDiscs discs(split);
        wallOperator walls(discs.geometry());
        walls.update(discs.surfaces());

        scalarField Jv(discs.p.size());
        vectorField f;
        walls.flux(discs.v, Jv);
        walls.transpose(discs.p, f);
        const scalar work = sum(f & discs.v);
        EXPECT_GT(mag(work), 0.1);
        EXPECT_NEAR(product(discs.p, Jv), work, 1e-12);

        // Objects of constant volume: no net flux, no force of a level
        EXPECT_NEAR(gSum(Jv), 0, 1e-12);
        walls.transpose(scalarField(discs.p.size(), 1), f);
        EXPECT_NEAR(max(mag(f)), 0, 1e-12);
    }
}


TEST(wallOperator, sameAtWalls)
{
    twoDiscs discs(0);
    wallOperator walls(discs.geometry());
    walls.update(discs.surfaces());
    const labelUList& cells = walls.cells();
    EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));

    scalarField Jv(discs.p.size());
    scalarField Jw(cells.size(), Zero);
    walls.flux(discs.v, Jv);
    walls.addFluxAtWalls(discs.v, Jw);
    forAll(cells, i)
    {
        EXPECT_EQ(Jv[cells[i]], Jw[i]);
        Jv[cells[i]] = 0;
    }
    EXPECT_EQ(gMax(mag(Jv)()), 0);

    vectorField f, fw;
    walls.transpose(discs.p, f);
    walls.transposeAtWalls(walls.atWalls(discs.p), fw);
    EXPECT_EQ(f, fw);
}


// Two discs, links' viscosity and fluid's density, a matrix of a diagonal
struct linkedDiscs
:
    twoDiscs
{
    const scalar viscosity = 0.3;
    const scalar density = 7;
    redBlackMatrix matrix;
    linkOperator operation;
    scalarField diagonal;
    vectorField source;

    explicit linkedDiscs(const direction split)
    :
        twoDiscs(split),
        matrix(grid()),
        operation(matrix, 2),
        diagonal(U.size(), 2),
        source(U.size(), vector(3, 4, 0))
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
        vectorField found(v.size(), Zero);
        operation.addForce(density, found);
        EXPECT_LT(max(mag(found - force)), tolerance);
        EXPECT_GT(max(mag(force)), 0.1);
    }
};


TEST(linkOperator, sumsTheLinks)
{
    for (direction split = 0; split < 2; ++split)
    {
        linkedDiscs discs(split);
        discs.addSources(discs.v);
        discs.operation.setSources(discs.v);
        forAll(discs.source, celli)
        {
            const scalar* found =
                discs.matrix.source(discs.matrix.row(celli));
            EXPECT_NEAR(found[0], discs.source[celli].x(), 1e-13) << celli;
            EXPECT_NEAR(found[1], discs.source[celli].y(), 1e-13) << celli;
        }
        discs.expectForces(1e-12);
    }
}


TEST(linkOperator, correctsTheLinks)
{
    for (direction split = 0; split < 2; ++split)
    {
        linkedDiscs discs(split);
        redBlackMatrix& matrix = discs.matrix;
        discs.operation.setSources(discs.v);
        const scalar norm = matrix.sourceNorm();
        matrix.startCorrection(norm);
        discs.operation.startCorrection(discs.v);

        // Residuals with other velocities of the nodes
        const vectorField later(2*discs.v + vector(0.3, -0.4, 0));
        discs.addSources(later);
        discs.operation.setResiduals(later);
        forAll(discs.source, celli)
        {
            const vector expected
            (
                discs.source[celli] - discs.diagonal[celli]*discs.U[celli]
            );
            const floatScalar* found = matrix.residual(matrix.row(celli));
            EXPECT_NEAR(found[0], expected.x()/norm, 1e-6) << celli;
            EXPECT_NEAR(found[1], expected.y()/norm, 1e-6) << celli;
        }

        // Forces of the corrected velocities, which the diagonal alone gives
        EXPECT_GT(matrix.sweep(1), 0.01);
        vectorField corrected(discs.U.size(), Zero);
        matrix.addTo(corrected);
        discs.U.primitiveFieldRef() = corrected;
        discs.expectForces(1e-10);
        forAll(corrected, celli)
        {
            const vector expected(discs.source[celli]/discs.diagonal[celli]);
            EXPECT_NEAR(corrected[celli].x(), expected.x(), 1e-5) << celli;
            EXPECT_NEAR(corrected[celli].y(), expected.y(), 1e-5) << celli;
        }
    }
}


TEST(immersedFluid, gradientOfALinearPressure)
{
    const vector slope(2, -3, 0);
    for (direction split = 0; split < 2; ++split)
    {
        twoDiscs discs(split);
        const fvMesh& mesh = discs.mesh();
        volScalarField p
        (
            IOobject("p", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimless, Zero),
            "zeroGradient"
        );
        p.primitiveFieldRef() = slope & mesh.C().primitiveField();
        p.correctBoundaryConditions();
        const immersedFluid fluid(discs.geometry(), dictionary());
        const volVectorField gradient(fluid.gradient(p));

        // Fluid cells, and solid ones beside them, have it; others have none
        const boolList& isFluid = discs.geometry().fluidCell();
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
    }
}


// ************************************************************************* //
