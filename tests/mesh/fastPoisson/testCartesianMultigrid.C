// SPDX-License-Identifier: GPL-3.0-or-later

// cartesianMultigrid as the coupling uses it: a symmetric positive operation,
// with a diagonal added, and conjugate gradients with a term beside the
// matrix, which changes from one solution to the next

#include <gtest/gtest.h>
#include "cartesianMultigrid.H"
#include "poissonProblem.H"
#include "poissonCases.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Values in (-1, 1) that do not depend on the decomposition
scalarField randomField(const latticeMesh& mesh, const label seed)
{
    scalarField result(mesh.cells().size());
    forAll(result, celli)
    {
        result[celli] =
            2*poissonProblem::random(mesh.cells()[celli], seed) - 1;
    }
    return result;
}

//- Small levels are shared too
dictionary smallGather(const word& cycle = "W")
{
    dictionary controls;
    controls.add("cycle", cycle);
    controls.add("gatherCells", label(120));
    return controls;
}

latticeOptions box(const label nx, const label ny, const label nz = 1)
{
    latticeOptions options;
    options.n = labelVector(nx, ny, nz);
    options.emptyDirection = nz > 1 ? 3 : 2;
    return options;
}

//- Square objects of 6 x 6 cells in fields of 16 x 16 that each resist their
//  compression, K = -sum over objects of stiffness g g^T, whichever ranks
//  their cells are on. The matrix is negative, and so is K
class squares
:
    public cartesianMultigrid::addedTerm
{
    const List<labelVector>& cells_;
    label nRow_;
    scalar stiffness_;

    //- Share of a cell in its object, 0 outside
    scalar share(const label celli) const
    {
        const labelVector& c = cells_[celli];
        return (c.x() % 16 < 6 && c.y() % 16 < 6) ? 1 : 0;
    }

    label object(const label celli) const
    {
        const labelVector& c = cells_[celli];
        return c.x()/16 + nRow_*(c.y()/16);
    }

public:

    squares(const latticeMesh& mesh, label nRow, scalar stiffness)
    :
        cells_(mesh.cells()),
        nRow_(nRow),
        stiffness_(stiffness)
    {}

    //- The row sums of K
    scalarField diagonal() const
    {
        scalarField ones(cells_.size(), 1);
        scalarField result(cells_.size(), Zero);
        add(result, ones);
        return result;
    }

    void add(scalarField& Ax, const scalarField& x) const override
    {
        scalarField total(nRow_*nRow_, Zero);
        forAll(cells_, celli)
        {
            total[object(celli)] += share(celli)*x[celli];
        }
        Pstream::listCombineGather(total, plusEqOp<scalar>());
        Pstream::listCombineScatter(total);
        forAll(cells_, celli)
        {
            Ax[celli] -= stiffness_*share(celli)*total[object(celli)];
        }
    }
};

//- What must hold for conjugate gradients
void checkSymmetry
(
    latticeMesh& mesh,
    poissonProblem& problem,
    const word& cycle
)
{
    tmp<fvScalarMatrix> eqn(problem.completeEquation());
    cartesianMultigrid multigrid(mesh.mesh(), smallGather(cycle));
    multigrid.update(eqn(), eqn().boundaryCoeffs(), problem.interfaces());
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
    EXPECT_LT(aMa, 0) << cycle;
    EXPECT_LT(bMb, 0) << cycle;
    EXPECT_NEAR
    (
        gSumProd(a, Mb), gSumProd(b, Ma), 1e-5*Foam::sqrt(aMa*bMb)
    ) << cycle;
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
        checkSymmetry(mesh, problem, "V");
        checkSymmetry(mesh, problem, "W");
    }
}


TEST(cartesianMultigrid, solvesWithATerm)
{
    latticeOptions options(box(64, 64));

    // Ranks' boxes, and cells scattered over the ranks
    for (const bool scattered : {false, true})
    {
        if (scattered)
        {
            options.shuffled = true;
            options.rank = [](const labelVector& c)
            {
                return (c.x()/5 + c.y()/7) % Pstream::nProcs();
            };
        }
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {});
        tmp<fvScalarMatrix> eqn(problem.completeEquation());

        for (const scalar stiffness : {0.01, 1.0})
        {
            // b = (A + K) x for a known x
            const squares term(mesh, 4, stiffness);
            const scalarField& exact = problem.exact();
            scalarField b(exact.size());
            eqn().Amul
            (
                b, exact, eqn().boundaryCoeffs(), problem.interfaces(), 0
            );
            term.add(b, exact);

            cartesianMultigrid::loopControls controls;
            controls.tolerance = 1e-11;
            cartesianMultigrid multigrid(mesh.mesh(), smallGather());
            multigrid.update
            (
                eqn(), eqn().boundaryCoeffs(), problem.interfaces(),
                term.diagonal()
            );
            scalarField x(exact.size(), Zero);
            const solverPerformance result =
                multigrid.solve(x, b, "p", controls, &term);
            EXPECT_TRUE(result.converged()) << stiffness;
            EXPECT_LT(difference(x, exact), 1e-7) << stiffness;
        }
    }
}


TEST(cartesianMultigrid, addedDiagonalHelps)
{
    latticeMesh mesh(box(64, 64));
    poissonProblem problem(mesh, {});
    tmp<fvScalarMatrix> eqn(problem.completeEquation());
    const scalarField b(randomField(mesh, 4));

    // A term that is its own diagonal
    struct holdsCells : public cartesianMultigrid::addedTerm
    {
        scalarField diagonal;

        void add(scalarField& Ax, const scalarField& x) const override
        {
            Ax += diagonal*x;
        }
    } term;
    term.diagonal = -3*pos(randomField(mesh, 3) - 0.7);

    label count[2];
    for (label added = 0; added < 2; ++added)
    {
        cartesianMultigrid multigrid(mesh.mesh(), smallGather());
        multigrid.update
        (
            eqn(), eqn().boundaryCoeffs(), problem.interfaces(),
            added ? term.diagonal : scalarField()
        );
        scalarField x(b.size(), Zero);
        cartesianMultigrid::loopControls controls;
        controls.tolerance = 1e-10;
        const solverPerformance result =
            multigrid.solve(x, b, "p", controls, &term);
        EXPECT_TRUE(result.converged());
        count[added] = result.nIterations();
    }
    EXPECT_LE(count[1], 16);
    EXPECT_LT(2*count[1], count[0]);
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
    multigrid.update(eqn(), eqn().boundaryCoeffs(), problem.interfaces());
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
                eqn(), eqn().boundaryCoeffs(), problem.interfaces(),
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
        multigrid.update(eqn(), eqn().boundaryCoeffs(), problem.interfaces());
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


TEST(cartesianMultigrid, refusesAnUnknownCycle)
{
    latticeMesh mesh(box(8, 8));
    EXPECT_THROW
    (
        cartesianMultigrid(mesh.mesh(), smallGather("F")), Foam::IOerror
    );
}


// ************************************************************************* //
