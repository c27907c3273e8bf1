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


TEST(linkOperator, sumsTheLinks)
{
    const scalar viscosity = 0.3, density = 7;
    for (direction split = 0; split < 2; ++split)
    {
        twoDiscs discs(split);
        const UList<wallLink>& links = discs.geometry().wallLinks();
        fvVectorMatrix equation(discs.U, dimVolume*dimAcceleration);
        equation.diag() = 2;
        equation.upper() = 0;
        equation.source() = vector(3, 4, 0);
        colouredMatrix matrix(discs.grid());
        matrix.set(equation);

        // Link by link
        vectorField source(equation.source());
        vectorField force(discs.v.size(), Zero);
        for (const wallLink& link : links)
        {
            const scalar g = viscosity*link.conductance;
            source[link.cell] += g*link.place.interpolate(discs.v);
            link.place.spread(force, density*g*discs.U[link.cell]);
        }

        linkOperator operation(matrix, 2);
        operation.set(links, viscosity);
        operation.setSources(discs.v);
        forAll(source, celli)
        {
            const scalar* found = matrix.source(matrix.row(celli));
            EXPECT_NEAR(found[0], source[celli].x(), 1e-13) << celli;
            EXPECT_NEAR(found[1], source[celli].y(), 1e-13) << celli;
        }
        vectorField found(discs.v.size(), Zero);
        operation.addForce(density, found);
        EXPECT_LT(max(mag(found - force)), 1e-12);
        EXPECT_GT(max(mag(force)), 0.1);
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
