// SPDX-License-Identifier: GPL-3.0-or-later

// cartesianMultigrid as others call it: a symmetric positive operation, with
// a diagonal added, and conjugate gradients with a term beside the matrix

#include <gtest/gtest.h>
#include "cartesianMultigrid.H"
#include "poissonProblem.H"
#include "poissonCases.H"
#include <random>

using namespace Foam;
using namespace Foam::fsi;

namespace
{

scalarField randomField(const label size, const label seed)
{
    std::mt19937 generator(seed + 100*Pstream::myProcNo());
    std::uniform_real_distribution<scalar> uniform(-1, 1);
    scalarField result(size);
    for (scalar& value : result)
    {
        value = uniform(generator);
    }
    return result;
}

//- A term that holds some cells: K x = -beta x there (the matrix is negative)
class diagonalTerm
:
    public cartesianMultigrid::addedTerm
{
public:

    scalarField diagonal;

    explicit diagonalTerm(const latticeMesh& mesh)
    :
        diagonal(mesh.cells().size(), Zero)
    {
        forAll(diagonal, celli)
        {
            const labelVector& c = mesh.cells()[celli];
            diagonal[celli] = (c.x() % 16 < 6 && c.y() % 16 < 6) ? -3 : 0;
        }
    }

    void add(scalarField& Ax, const scalarField& x) const override
    {
        Ax += diagonal*x;
    }
};

//- A mesh of 64 x 48 cells whose levels are shared
latticeMesh& sharedMesh()
{
    static latticeOptions options;
    options.n = labelVector(64, 48, 1);
    static latticeMesh mesh(options);
    return mesh;
}

} // End namespace


TEST(cartesianMultigrid, isSymmetricAndPositive)
{
    latticeOptions options;
    options.n = labelVector(64, 45, 1);
    options.cyclic[1] = true;
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {"xMin"});
    problem.randomCoefficients();
    tmp<fvScalarMatrix> eqn(problem.equation());
    const lduInterfaceFieldPtrsList interfaces
    (
        problem.p().boundaryField().scalarInterfaces()
    );

    for (const word cycle : {"V", "W"})
    {
        dictionary controls;
        controls.add("cycle", cycle);
        controls.add("gatherCells", label(120));
        cartesianMultigrid multigrid(mesh.mesh(), controls);
        multigrid.update(eqn(), eqn().boundaryCoeffs(), interfaces);

        const label size = mesh.cells().size();
        const scalarField a(randomField(size, 1));
        const scalarField b(randomField(size, 2));
        scalarField Ma(size), Mb(size);
        multigrid.precondition(Ma, a);
        multigrid.precondition(Mb, b);
        const scalar aMb = gSumProd(a, Mb);
        const scalar bMa = gSumProd(b, Ma);
        const scalar aMa = gSumProd(a, Ma);
        const scalar bMb = gSumProd(b, Mb);

        // The matrix is negative
        EXPECT_LT(aMa, 0);
        EXPECT_LT(bMb, 0);
        EXPECT_NEAR(aMb, bMa, 1e-5*Foam::sqrt(aMa*bMb)) << cycle;
    }
}


TEST(cartesianMultigrid, solvesWithATerm)
{
    latticeMesh& mesh = sharedMesh();
    poissonProblem problem(mesh, {});
    tmp<fvScalarMatrix> eqn(problem.equation());
    const lduInterfaceFieldPtrsList interfaces
    (
        problem.p().boundaryField().scalarInterfaces()
    );
    const diagonalTerm term(mesh);

    // b = (A + K) x for a known x
    const scalarField& exact = problem.exact();
    scalarField b(exact.size());
    eqn().Amul(b, exact, eqn().boundaryCoeffs(), interfaces, 0);
    term.add(b, exact);

    cartesianMultigrid::loopControls controls;
    controls.tolerance = 1e-11;
    cartesianMultigrid multigrid(mesh.mesh(), dictionary());
    label count[2];
    for (label added = 0; added < 2; ++added)
    {
        multigrid.update
        (
            eqn(), eqn().boundaryCoeffs(), interfaces,
            added ? term.diagonal : scalarField()
        );
        scalarField x(exact.size(), Zero);
        const solverPerformance result =
            multigrid.solve(x, b, "p", controls, &term);
        EXPECT_TRUE(result.converged());
        EXPECT_LT(difference(x, exact), 1e-7);
        count[added] = result.nIterations();
    }

    // The diagonal in the preconditioner is what keeps the count low
    EXPECT_LE(count[1], 16);
    EXPECT_LT(count[1], count[0]);
}


TEST(cartesianMultigrid, keepsCellsWithoutCouplings)
{
    latticeMesh& mesh = sharedMesh();
    poissonProblem problem(mesh, {});
    problem.mask
    (
        [](const labelVector& c) { return c.x() % 8 < 3 && c.y() % 8 < 3; },
        nullptr
    );
    tmp<fvScalarMatrix> eqn(problem.equation());
    cartesianMultigrid multigrid(mesh.mesh(), dictionary());
    multigrid.update
    (
        eqn(), eqn().boundaryCoeffs(),
        problem.p().boundaryField().scalarInterfaces()
    );
    scalarField z(mesh.cells().size());
    const scalarField r(randomField(z.size(), 3));
    multigrid.precondition(z, r);
    forAll(z, celli)
    {
        const labelVector& c = mesh.cells()[celli];
        if (c.x() % 8 < 3 && c.y() % 8 < 3)
        {
            const scalar expected = r[celli]/eqn().diag()[celli];
            EXPECT_NEAR(z[celli], expected, 1e-5);
        }
    }
}


// ************************************************************************* //
