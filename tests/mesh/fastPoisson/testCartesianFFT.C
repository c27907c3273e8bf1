// SPDX-License-Identifier: GPL-3.0-or-later

// cartesianFFT must give the discrete solution at once whatever the patches,
// spacing, cell order and decomposition, and refuse what it cannot solve

#include <gtest/gtest.h>
#include "poissonProblem.H"
#include "poissonCases.H"
#include "needsThrownErrors.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const string transforms("solver cartesianFFT; tolerance 1e-11; relTol 0;");

void check(poissonProblem& problem, const std::string& name)
{
    const poissonResult found = problem.solve(transforms);
    EXPECT_TRUE(found.converged) << name;
    EXPECT_LE(found.nIterations, 2) << name;
    EXPECT_LT(difference(found.p, problem.exact()), 1e-8) << name;
}

//- The message of the error that a problem ends with; empty: there is none
std::string errorOf(poissonProblem& problem)
{
    try
    {
        problem.solve(transforms);
    }
    catch (const Foam::error& err)
    {
        return err.message();
    }
    return "";
}

} // End namespace


TEST(cartesianFFT, solvesEveryPatchCombination2D)
{
    for (const label nx : {1, 2, 3, 38})
    {
        forPatchCombinations
        (
            labelVector(max(nx, label(Pstream::nProcs())), 27, 1),
            2,
            [](latticeMesh& mesh, const wordList& fixed, const std::string& s)
            {
                poissonProblem problem(mesh, fixed);
                check(problem, s);
            }
        );
    }
}


TEST(cartesianFFT, solvesEveryPatchCombination3D)
{
    forPatchCombinations
    (
        labelVector(12, 9, 7),
        3,
        [](latticeMesh& mesh, const wordList& fixed, const std::string& name)
        {
            poissonProblem problem(mesh, fixed);
            check(problem, name);
        }
    );
}


TEST(cartesianFFT, fixesTheReferenceCell)
{
    latticeOptions options;
    options.n = labelVector(25, 16, 1);
    options.shuffled = true;
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {});
    problem.setReference(3.5);
    const poissonResult found = problem.solve(transforms);
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.nIterations, 2);
    EXPECT_LT(difference(found.p, problem.exact()), 1e-8);

    // The level is what was asked for
    scalar level = -GREAT;
    if (Pstream::master())
    {
        level = found.p[0] + found.mean;
    }
    EXPECT_NEAR(returnReduce(level, maxOp<scalar>()), 3.5, 1e-8);
}


TEST(cartesianFFT, solvesWithTimeDerivative)
{
    latticeOptions options;
    options.n = labelVector(20, 31, 1);
    options.spacing = vector(1, 0.1, 1);
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {"yMin"});
    problem.addDiagonal(0.7);
    check(problem, "time derivative");
}


TEST(cartesianFFT, decompositionDoesNotMatter)
{
    latticeOptions options;
    options.n = labelVector(30, 22, 1);
    options.cyclic[1] = true;
    options.rank = [](const labelVector& c)
    {
        return (c.x()/5 + c.y()/7) % Pstream::nProcs();
    };
    options.shuffled = true;
    {
        latticeMesh mesh(options);
        poissonProblem problem(mesh, {"xMax"});
        check(problem, "chess board");
    }

    // Ranks without cells
    options.rank = [](const labelVector& c)
    {
        return c.x() < 14 ? 0 : Pstream::nProcs() - 1;
    };
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {"xMax"});
    check(problem, "two ranks");
}


TEST(cartesianFFT, refusesVariableCoefficients)
{
    NEEDS_THROWN_ERRORS
    latticeOptions options;
    options.n = labelVector(12, 12, 1);
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {});
    problem.randomCoefficients();
    const std::string message = errorOf(problem);
    EXPECT_NE(message.find("cartesianMG"), std::string::npos) << message;
    EXPECT_NE(message.find("GAMG"), std::string::npos) << message;
}


TEST(cartesianFFT, refusesHoles)
{
    NEEDS_THROWN_ERRORS
    latticeOptions options;
    options.n = labelVector(12, 12, 1);
    options.hole = [](const labelVector& c)
    {
        return c.x() > 8 && c.y() > 8;
    };
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {"xMin"});
    EXPECT_NE(errorOf(problem).find("GAMG"), std::string::npos);
}


TEST(cartesianFFT, preconditionsVariableCoefficients)
{
    latticeOptions options;
    options.n = labelVector(40, 36, 1);
    latticeMesh mesh(options);
    for (const wordList& fixed : {wordList(), wordList({"xMin"})})
    {
        poissonProblem problem(mesh, fixed);
        problem.randomCoefficients();
        const poissonResult found = problem.solve
        (
            "solver PCG; preconditioner cartesianFFT; tolerance 1e-11;"
            " relTol 0;"
        );
        EXPECT_TRUE(found.converged);
        EXPECT_LE(found.nIterations, 120);
        EXPECT_LT(difference(found.p, problem.exact()), 1e-7);
    }
}


// ************************************************************************* //
