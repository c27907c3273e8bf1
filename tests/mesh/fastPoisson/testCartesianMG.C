// SPDX-License-Identifier: GPL-3.0-or-later

// cartesianMG against PCG with DIC: patches, spacing, cell order, holes and
// decomposition must not change the solution, and hardly the iterations

#include <gtest/gtest.h>
#include "poissonProblem.H"
#include "poissonCases.H"
#include "needsThrownErrors.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

// Small gatherCells: on several ranks most levels shall be shared
const string multigrid
(
    "solver cartesianMG; tolerance 1e-11; relTol 0; gatherCells 120;"
);

//- Solve and compare with the known solution and, in serial, with that of a
//  stock solver; returns the iterations of cartesianMG
label compare(poissonProblem& problem, const std::string& name)
{
    const poissonResult found = problem.solve(multigrid);
    EXPECT_TRUE(found.converged) << name;
    EXPECT_LT(difference(found.p, problem.exact()), 1e-7) << name;
    if (!Pstream::parRun())
    {
        const poissonResult expected = problem.solve(referenceControls());
        EXPECT_TRUE(expected.converged) << name;
        EXPECT_LT(difference(found.p, expected.p), 1e-7) << name;
    }
    return found.nIterations;
}

} // End namespace


TEST(cartesianMG, solvesEveryPatchCombination2D)
{
    forPatchCombinations
    (
        labelVector(38, 27, 1),
        2,
        [](latticeMesh& mesh, const wordList& fixed, const std::string& name)
        {
            poissonProblem problem(mesh, fixed);
            EXPECT_LE(compare(problem, name), 20) << name;
        }
    );
}


TEST(cartesianMG, solvesEveryPatchCombination3D)
{
    forPatchCombinations
    (
        labelVector(12, 9, 7),
        3,
        [](latticeMesh& mesh, const wordList& fixed, const std::string& name)
        {
            poissonProblem problem(mesh, fixed);
            EXPECT_LE(compare(problem, name), 20) << name;
        }
    );
}


TEST(cartesianMG, solvesInAnyPlane)
{
    for (label empty = 0; empty < 3; ++empty)
    {
        latticeOptions options;
        options.n = labelVector(24, 24, 24);
        options.n[empty] = 1;
        options.emptyDirection = empty;
        options.rank = halves((empty + 1) % 3, 24);
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {});
        EXPECT_LE(compare(problem, "plane"), 16);
    }
}


TEST(cartesianMG, solvesWithAnisotropicSpacing)
{
    for (const scalar ratio : {0.01, 0.2, 3.0, 100.0})
    {
        latticeOptions options;
        options.n = labelVector(32, 27, 1);
        options.spacing = vector(1, ratio, 1);
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {"xMin"});
        EXPECT_LE(compare(problem, "ratio " + name(ratio)), 24) << ratio;
    }
}


TEST(cartesianMG, solvesWithVariableCoefficients)
{
    latticeOptions options;
    options.n = labelVector(40, 36, 1);
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {});
    problem.randomCoefficients();
    EXPECT_LE(compare(problem, "variable"), 24);
}


TEST(cartesianMG, cellOrderDoesNotMatter)
{
    latticeOptions options;
    options.n = labelVector(30, 20, 1);
    latticeMesh natural(options);
    poissonProblem ordered(natural, {"yMax"});
    const label nOrdered = compare(ordered, "natural");

    options.shuffled = true;
    latticeMesh random(options);
    poissonProblem shuffled(random, {"yMax"});
    EXPECT_EQ(compare(shuffled, "shuffled"), nOrdered);
}


TEST(cartesianMG, solvesAroundHoles)
{
    latticeOptions options;
    options.n = labelVector(32, 32, 1);
    options.hole = [](const labelVector& c)
    {
        return c.x() < 12 && c.y() < 12;
    };
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {"xMax"});
    EXPECT_LE(compare(problem, "step"), 20);
}


TEST(cartesianMG, decompositionDoesNotMatter)
{
    const label nRanks = Pstream::nProcs();
    const std::vector<std::function<label(const labelVector&)>> ranks
    {
        [=](const labelVector& c) { return c.y()*nRanks/40; },
        [=](const labelVector& c)
        {
            return (2*c.x()/48 + 2*(2*c.y()/40)) % nRanks;
        },
        [=](const labelVector& c) { return (c.x()/5 + c.y()/7) % nRanks; },
        // Ranks without cells
        [=](const labelVector& c) { return c.x() < 24 ? 0 : nRanks - 1; },
        [=](const labelVector&) { return nRanks - 1; }
    };
    for (const bool cyclic : {false, true})
    {
        label least = labelMax;
        label most = 0;
        for (const auto& rank : ranks)
        {
            latticeOptions options;
            options.n = labelVector(48, 40, 1);
            options.cyclic[0] = cyclic;
            options.rank = rank;
            latticeMesh mesh(options);
            poissonProblem problem(mesh, {});
            const label n = compare(problem, "decomposition");
            least = min(least, n);
            most = max(most, n);
        }
        EXPECT_LE(most - least, 2);
        EXPECT_LE(most, 16);
    }
}


// Three boxes cannot be cut from 2 x 2 cells
TEST(cartesianMG, moreRanksThanBoxes)
{
    latticeOptions options;
    options.n = labelVector(2, 2, 1);
    options.rank = [](const labelVector& c)
    {
        return (c.x() + c.y()) % Pstream::nProcs();
    };
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {"xMax"});
    EXPECT_LE(compare(problem, "few cells"), 8);
}


TEST(cartesianMG, iterationsHardlyGrowWithTheGrid)
{
    for (const label n : {32, 64, 128, 256})
    {
        latticeOptions options;
        options.n = labelVector(n, n, 1);
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {});
        const poissonResult result =
            problem.solve("solver cartesianMG; tolerance 1e-6; relTol 0;");
        EXPECT_TRUE(result.converged);
        EXPECT_LE(result.nIterations, 9) << n;
    }
}


TEST(cartesianMG, preconditionsTheStockSolver)
{
    latticeOptions options;
    options.n = labelVector(50, 34, 1);
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {"xMin"});
    for (const string cells : {"1", "1000"})
    {
        const poissonResult found = problem.solve
        (
            "solver PCG; preconditioner { preconditioner cartesianMG; "
            "wCycleCells " + cells + "; } tolerance 1e-11; relTol 0;"
        );
        EXPECT_TRUE(found.converged);
        EXPECT_LE(found.nIterations, 24);
        EXPECT_LT(difference(found.p, problem.exact()), 1e-7);
    }
}


TEST(cartesianMG, refusesEntriesThatNoSolverReads)
{
    NEEDS_THROWN_ERRORS
    latticeOptions options;
    options.n = labelVector(8, 8, 1);
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {});
    for
    (
        const string& controls
      : {
            "solver cartesianMG; wCycleFrom 2;",
            "solver cartesianFFT; wCycleFrom 2;",
            "solver PCG; preconditioner { preconditioner cartesianMG;"
            " wCycleFrom 2; }"
        }
    )
    {
        try
        {
            problem.solve(controls);
            ADD_FAILURE() << controls;
        }
        catch (const Foam::error& err)
        {
            const std::string message(err.message());
            EXPECT_NE(message.find("'wCycleFrom'"), std::string::npos);
            EXPECT_NE(message.find("gatherCells"), std::string::npos);
        }
    }
}


TEST(cartesianMG, refusesOtherMeshes)
{
    NEEDS_THROWN_ERRORS
    latticeOptions stretched;
    stretched.n = labelVector(8, 8, 1);
    stretched.distort = [](const point& p)
    {
        return point(p.x()*(1 + 0.1*p.x()), p.y(), p.z());
    };
    latticeOptions sheared;
    sheared.n = labelVector(8, 8, 1);
    sheared.distort = [](const point& p)
    {
        return point(p.x() + 0.3*p.y(), p.y(), p.z());
    };
    for (const latticeOptions& options : {stretched, sheared})
    {
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {});
        try
        {
            problem.solve(multigrid);
            ADD_FAILURE() << "accepted";
        }
        catch (const Foam::error& err)
        {
            const std::string message(err.message());
            EXPECT_NE(message.find("GAMG"), std::string::npos)
                << err.message();
        }
    }
}


// ************************************************************************* //
