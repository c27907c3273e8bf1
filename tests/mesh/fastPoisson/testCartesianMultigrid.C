// SPDX-License-Identifier: GPL-3.0-or-later

// cartesianMultigrid as the coupling uses it: a symmetric positive operation,
// for matrices that change from one solution to the next

#include <gtest/gtest.h>
#include "multigridCases.H"
#include "openfoamMesh.H"
#include "needsThrownErrors.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Check the symmetry that conjugate gradients need
void checkSymmetry
(
    latticeMesh& mesh,
    poissonProblem& problem,
    const label wCycleCells
)
{
    tmp<fvScalarMatrix> eqn(problem.completeEquation());
    cartesianMultigrid multigrid(mesh.mesh(), smallGather(wCycleCells));
    multigrid.update(eqn(), boundaryCoeffsOf(eqn()), problem.interfaces());
    EXPECT_GT(multigrid.nLevels(), 2);

    const scalarField a(randomField(mesh, 1));
    const scalarField b(randomField(mesh, 2));
    scalarField Ma(a.size());
    scalarField Mb(a.size());
    multigrid.precondition(Ma, a);
    multigrid.precondition(Mb, b);
    const scalar aMa = gSumProd(a, Ma);
    const scalar bMb = gSumProd(b, Mb);

    // The matrix is negative
    EXPECT_LT(aMa, 0) << wCycleCells;
    EXPECT_LT(bMb, 0) << wCycleCells;
    EXPECT_NEAR
    (
        gSumProd(a, Mb), gSumProd(b, Ma), 1e-5*Foam::sqrt(aMa*bMb)
    ) << wCycleCells;
}

} // End namespace


TEST(cartesianMultigrid, isSymmetricAndPositive)
{
    for (latticeOptions options : {box(64, 45), box(16, 13, 18)})
    {
        options.cyclic[1] = true;
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {"xMin"});
        problem.randomCoefficients();
        checkSymmetry(mesh, problem, 1);
        checkSymmetry(mesh, problem, 500);
        checkSymmetry(mesh, problem, labelMax);
    }
}


TEST(cartesianMultigrid, keepsCellsWithoutCouplings)
{
    latticeMesh mesh(box(64, 48));
    poissonProblem problem(mesh, {});
    const auto solid = [](const labelVector& c)
    {
        return c.x() % 8 < 3 && c.y() % 8 < 3;
    };
    problem.mask(solid, nullptr);
    tmp<fvScalarMatrix> eqn(problem.completeEquation());
    cartesianMultigrid multigrid(mesh.mesh(), smallGather());
    multigrid.update(eqn(), boundaryCoeffsOf(eqn()), problem.interfaces());
    scalarField z(mesh.cells().size());
    const scalarField r(randomField(mesh, 3));
    multigrid.precondition(z, r);
    label nSolid = 0;
    forAll(z, celli)
    {
        if (solid(mesh.cells()[celli]))
        {
            ++nSolid;
            EXPECT_NEAR(z[celli], r[celli]/eqn().diag()[celli], 1e-6);
        }
    }
    EXPECT_EQ(returnReduce(nSolid, sumOp<label>()), 8*6*9);
}


TEST(cartesianMultigrid, forgetsTheLastMatrix)
{
    // Open, masked, open again: as a new object, to the last bit
    latticeMesh mesh(box(48, 40));
    cartesianMultigrid used(mesh.mesh(), smallGather());
    const scalarField b(randomField(mesh, 5));
    for (const label masked : {0, 1, 0})
    {
        poissonProblem problem(mesh, {});
        if (masked)
        {
            problem.mask
            (
                [](const labelVector& c)
                {
                    return c.x() % 9 < 4 && c.y() % 9 < 4;
                },
                nullptr
            );
        }
        problem.addDiagonal(0.01);
        tmp<fvScalarMatrix> eqn(problem.completeEquation());
        const scalarField added(b.size(), masked ? -0.5 : 0);
        cartesianMultigrid fresh(mesh.mesh(), smallGather());
        scalarField x[2];
        label i = 0;
        for (cartesianMultigrid* multigrid : {&fresh, &used})
        {
            multigrid->update
            (
                eqn(), boundaryCoeffsOf(eqn()), problem.interfaces(),
                masked ? added : scalarField()
            );
            x[i].setSize(b.size(), 0);
            multigrid->solve
            (
                x[i], b, "p", cartesianMultigrid::loopControls()
            );
            ++i;
        }
        EXPECT_EQ(difference(x[0], x[1]), 0) << masked;
        EXPECT_GT(gMax(mag(x[0])()), 0);
    }
}


TEST(cartesianMultigrid, signDoesNotMatter)
{
    latticeMesh mesh(box(40, 30));
    poissonProblem problem(mesh, {"yMin"});
    scalarField x[2];
    label count[2];
    for (label positive = 0; positive < 2; ++positive)
    {
        tmp<fvScalarMatrix> eqn(problem.completeEquation());
        if (positive)
        {
            eqn.ref().negate();
        }
        cartesianMultigrid multigrid(mesh.mesh(), smallGather());
        multigrid.update(eqn(), boundaryCoeffsOf(eqn()), problem.interfaces());
        x[positive].setSize(mesh.cells().size(), 0);
        count[positive] = multigrid.solve
        (
            x[positive], eqn().source(), "p",
            cartesianMultigrid::loopControls()
        ).nIterations();
    }
    EXPECT_EQ(count[0], count[1]);
    EXPECT_LT(difference(x[0], x[1]), 1e-12);
    EXPECT_LT(difference(x[0], problem.exact()), 1e-3);
}


TEST(cartesianMultigrid, velocityErrorDoesNotDependOnThePressure)
{
    // The pressure of a large step makes many times the velocity that there
    // is; it starts wrong by about this velocity
    for (latticeOptions options : {box(64, 64), box(24, 20, 16)})
    {
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {});
        tmp<fvScalarMatrix> eqn(problem.completeEquation());
        cartesianMultigrid multigrid(mesh.mesh(), smallGather());
        multigrid.update(eqn(), boundaryCoeffsOf(eqn()), problem.interfaces());
        const auto energy = [&](const scalarField& x)
        {
            scalarField Ax(x.size());
            eqn().Amul
            (
                Ax, x, boundaryCoeffsOf(eqn()), problem.interfaces(), 0
            );
            return -sumProd(x, Ax);
        };
        const scalarField& shape = problem.exact();
        const scalarField difference(randomField(mesh, 6));
        for (const scalar size : {1.0, 1e2, 1e5})
        {
            const scalarField exact(size*shape);
            scalarField b(exact.size());
            eqn().Amul
            (
                b, exact, boundaryCoeffsOf(eqn()), problem.interfaces(), 0
            );
            cartesianMultigrid::loopControls controls;
            controls.tolerance = 1e-4;
            scalar error[2];
            for (label ofFlow = 0; ofFlow < 2; ++ofFlow)
            {
                scalarField x(exact + difference);
                controls.energy = ofFlow ? energy(difference) : -1;
                multigrid.solve(x, b, "p", controls);
                error[ofFlow] =
                    Foam::sqrt
                    (
                        returnReduce(energy(x - exact), sumOp<scalar>())
                       /returnReduce(energy(difference), sumOp<scalar>())
                    );
            }
            EXPECT_LT(error[1], 3e-4) << size;
            if (size > 1e4)
            {
                EXPECT_GT(error[0], 1e-2) << size;
            }
        }
    }
}


TEST(cartesianMultigrid, roundingErrorsOfAFlowHaveConverged)
{
    // Their residual does not fall to the tolerance
    latticeMesh mesh(box(32, 32));
    poissonProblem problem(mesh, {});
    tmp<fvScalarMatrix> eqn(problem.completeEquation());
    cartesianMultigrid multigrid(mesh.mesh(), smallGather());
    multigrid.update(eqn(), boundaryCoeffsOf(eqn()), problem.interfaces());
    cartesianMultigrid::loopControls controls;
    controls.tolerance = 1e-12;
    for (const scalar size : {1e-20, 1.0})
    {
        scalarField x(problem.exact().size(), Zero);
        controls.energy = 1;
        controls.maxIter = 2;
        const solverPerformance result
        (
            multigrid.solve(x, size*randomField(mesh, 6), "p", controls)
        );
        EXPECT_EQ(result.converged(), size < 1) << result.finalResidual();
    }
}


TEST(cartesianMultigrid, refusesACycleWithoutCells)
{
    NEEDS_THROWN_ERRORS
    latticeMesh mesh(box(8, 8));
    EXPECT_THROW
    (
        cartesianMultigrid(mesh.mesh(), smallGather(0)), Foam::IOerror
    );
}


// ************************************************************************* //
