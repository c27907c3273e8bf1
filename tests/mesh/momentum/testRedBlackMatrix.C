// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "cartesianMesh.H"
#include "openfoamVersion.H"
#include "redBlackMatrix.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"
#include "surfaceFields.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Velocities on a box whose walls move with (1 2 0)
volVectorField velocity(const fvMesh& mesh)
{
    volVectorField U
    (
        IOobject("U", nameOf(mesh.time()), mesh),
        mesh,
        dimensionedVector("U", dimVelocity, vector(1, 2, 0)),
        "fixedValue"
    );
    U.primitiveFieldRef() = Zero;
    U.correctBoundaryConditions();
    return U;
}


//- A source that changes from cell to cell
vectorField roughSource(const fvMesh& mesh)
{
    vectorField source(mesh.nCells());
    forAll(source, celli)
    {
        const scalar x = mesh.C()[celli].x();
        const scalar y = mesh.C()[celli].y();
        source[celli] = vector(Foam::sin(3*x + y), Foam::cos(2*y), 0);
    }
    return source;
}


//- Momentum equation of a fluid whose viscosity changes from face to face, so
//  that all coefficients differ, with a source besides the walls'
tmp<fvVectorMatrix> momentum(volVectorField& U, const vectorField& source)
{
    const fvMesh& mesh = U.mesh();
    surfaceScalarField nu
    (
        IOobject("nu", nameOf(mesh.time()), mesh),
        mesh,
        dimensionedScalar("nu", sqr(dimLength)/dimTime, 1.3)
    );
    const vector wave(5, 7, 3);
    nu += dimensionedScalar("more", sqr(dimLength)/dimTime, 0.9)
       *sin(mesh.Cf() & dimensionedVector("wave", dimless/dimLength, wave));
    tmp<fvVectorMatrix> tequation
    (
        fvm::Sp(dimensionedScalar("rate", dimless/dimTime, 0.7), U)
      - fvm::laplacian(nu, U)
    );
    tequation.ref().source() += source;
    return tequation;
}


//- Expect what OpenFOAM's solver gives
void expectSolution
(
    const volVectorField& U,
    const vectorField& source,
    const scalar tolerance
)
{
    volVectorField expected(velocity(U.mesh()));
    dictionary controls;
    controls.add("solver", "PCG");
    controls.add("preconditioner", "DIC");
    controls.add("tolerance", 1e-12);
    momentum(expected, source)->solve(controls);
    EXPECT_LT(gMax(mag(U - expected)().primitiveField()), tolerance);
}

//- Sweep until nothing changes
void sweepOften(redBlackMatrix& matrix)
{
    for (label i = 0; i < 200; ++i)
    {
        matrix.sweep(1.3);
    }
}


//- Correct the solution until nothing changes
void correctOften(redBlackMatrix& matrix)
{
    for (label i = 0; i < 4; ++i)
    {
        matrix.startCorrection(matrix.sourceNorm());
        sweepOften(matrix);
        matrix.addCorrection();
    }
}

} // End anonymous namespace


// Solve with walls that move, then add what another right-hand side makes
void checkSolutions(const labelVector& nCells, const boxLayout& layout)
{
    boxMesh box(nCells, nCells.z() > 1 ? 3 : 2, layout);
    const cartesianMesh grid(box.mesh());
    const vectorField none(box.mesh().nCells(), Zero);
    const vectorField source(roughSource(box.mesh()));

    volVectorField U(velocity(box.mesh()));
    const tmp<fvVectorMatrix> equation(momentum(U, none));
    redBlackMatrix matrix(grid);
    matrix.set(equation());
    correctOften(matrix);
    matrix.get(U.primitiveFieldRef());
    expectSolution(U, none, 1e-9);

    const scalar norm = Foam::sqrt(gSum(magSqr(source)));
    EXPECT_NEAR(matrix.startFromZero(source), norm, 1e-12*norm);
    sweepOften(matrix);
    EXPECT_TRUE(matrix.exhausted());
    matrix.addCorrection();
    correctOften(matrix);

    // The sums of what is expected in part, over some cells
    const vectorField before(U.primitiveField());
    boolList counts(U.size(), true);
    counts[1] = false;
    const FixedList<scalar, 2> squares
    (
        matrix.addTo(counts, source, 0.3, U.primitiveFieldRef())
    );
    expectSolution(U, source, 1e-9);
    scalar beyond = 0, values = 0;
    forAll(before, celli)
    {
        if (celli != 1)
        {
            const vector& u = U[celli];
            beyond += magSqr(u - before[celli] - 0.3*source[celli]);
            values += magSqr(u);
        }
    }
    EXPECT_NEAR(squares[0], beyond, 1e-12*beyond);
    EXPECT_NEAR(squares[1], values, 1e-12*values);
}


TEST(redBlackMatrix, solvesAndRespondsToAnotherSource)
{
    for (const label nX : {12, 9, -9})
    {
        // Odd and cyclic: neighbours of the same colour
        boxLayout layout;
        layout.cyclic[0] = nX < 0;
        layout.splitDirection = nX == 12 ? 0 : 1;
        checkSolutions(labelVector(mag(nX), 8, 1), layout);
        checkSolutions(labelVector(mag(nX), 8, 5), layout);
    }
}


TEST(redBlackMatrix, startsFromTheExpectedChange)
{
    boxMesh box(labelVector(8, 7, 1), 2);
    const cartesianMesh grid(box.mesh());
    const vectorField source(roughSource(box.mesh()));
    volVectorField U(velocity(box.mesh()));
    const tmp<fvVectorMatrix> equation(momentum(U, source));
    redBlackMatrix matrix(grid);
    matrix.set(equation());
    correctOften(matrix);
    vectorField rate(U.size());
    matrix.get(rate);
    rate -= U.primitiveField();
    rate /= 0.3;

    const auto firstResidual = [&](const expectedChange& change)
    {
        matrix.set(equation(), change);
        matrix.startCorrection(matrix.sourceNorm());
        return matrix.sweep(1);
    };
    EXPECT_GT(firstResidual(expectedChange()), 1e-3);
    EXPECT_LT(firstResidual(expectedChange(rate, 0.3)), 1e-12);
}


TEST(redBlackMatrix, firstSweepStartsFromZero)
{
    boxMesh box(labelVector(8, 7, 1), 2);
    const cartesianMesh grid(box.mesh());
    const vectorField source(roughSource(box.mesh()));
    volVectorField U(velocity(box.mesh()));
    volVectorField rest
    (
        IOobject("rest", nameOf(box.mesh().time()), box.mesh()),
        box.mesh(),
        dimensionedVector(dimVelocity, Zero),
        "fixedValue"
    );
    const tmp<fvVectorMatrix> equation(momentum(U, source));
    redBlackMatrix matrix(grid);
    matrix.set(equation());
    correctOften(matrix);
    matrix.startFromZero(source);

    // Another matrix, with walls and cells at rest, is swept as well
    const tmp<fvVectorMatrix> atRest(momentum(rest, source));
    redBlackMatrix other(grid);
    other.set(atRest());
    other.startCorrection(other.sourceNorm());
    other.sweep(1);
    other.addCorrection();
    vectorField found(source.size(), Zero);
    vectorField expected(source.size(), Zero);
    matrix.addTo(boolList(found.size(), true), source, 0, found);
    other.get(expected);
    EXPECT_LT(gMax(mag(found - expected)()), 1e-6*gMax(mag(expected)()));
    EXPECT_GT(gMax(mag(found)()), 1e-3);
}


TEST(redBlackMatrix, residualBelongsToTheValuesMet)
{
    boxMesh box(labelVector(10, 6, 1), 2);
    const cartesianMesh grid(box.mesh());
    const vectorField source(roughSource(box.mesh()));
    volVectorField U(velocity(box.mesh()));
    const tmp<fvVectorMatrix> equation(momentum(U, source));
    redBlackMatrix matrix(grid);
    matrix.set(equation());
    matrix.startCorrection(matrix.sourceNorm());
    const scalar first = matrix.sweep(1);
    scalar before = first;
    for (label i = 0; i < 10; ++i)
    {
        const scalar residual = matrix.sweep(1);
        EXPECT_LT(residual, before);
        before = residual;
    }
    sweepOften(matrix);
    EXPECT_LT(matrix.sweep(1), matrix.dropAtOnce()*first);
    matrix.addCorrection();

    // The solution in single precision is the solution's to double
    correctOften(matrix);
    matrix.startCorrection(matrix.sourceNorm());
    EXPECT_LT(matrix.sweep(1), 1e-14);
}


// One correction comes as far as dropAtOnce() says, at any dt nu/h^2
TEST(redBlackMatrix, correctionsReachTheDropTheyPromise)
{
    boxMesh box(labelVector(40, 40, 1), 2);
    const cartesianMesh grid(box.mesh());
    const vectorField source(roughSource(box.mesh()));
    for (const scalar rate : {1e3, 1.0, 1e-3})
    {
        volVectorField U(velocity(box.mesh()));
        fvVectorMatrix equation
        (
            fvm::Sp(dimensionedScalar("r", dimless/dimTime, rate), U)
          - fvm::laplacian
            (
                dimensionedScalar("nu", sqr(dimLength)/dimTime, 1), U
            )
        );
        equation.source() += source;
        redBlackMatrix matrix(grid);
        matrix.set(equation);
        matrix.startCorrection(matrix.sourceNorm());
        const scalar first = matrix.sweep(matrix.relaxation());
        scalar last = first;
        for (label i = 0; i < 1000; ++i)
        {
            last = matrix.sweep(matrix.relaxation());
        }
        EXPECT_LT(last, matrix.dropAtOnce()*first) << rate;
    }
}


// ************************************************************************* //
