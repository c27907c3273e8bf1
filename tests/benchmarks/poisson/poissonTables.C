// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Program
    poissonTables

Description
    Solves Poisson's equation on a uniform mesh by GAMG and by the solvers of
    libFastPoisson, in one run, and prints CSV: iterations, processor time of
    a solution with its set-up (median), of the first one, the ratio to GAMG,
    and the largest difference from the known discrete solution over its
    largest value. Fails if a solver did not find it; GAMG, the first, may end
    with its 1000 iterations, as with many discs.

Usage
    poissonTables patches2D|patches3D|discs N REPEATS [-solver NAME]
        [-parallel]

    On N cells a side, each solution repeated. See patchTable.C, discTable.C.
\*---------------------------------------------------------------------------*/

#include "poissonTables.H"
#include "openfoamCase.H"
#include <algorithm>
#include <cstdio>

// * * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * //

namespace
{

// The only solver that is asked for; empty: all
std::string wanted;

// Solutions are not repeated for longer than this [s]
constexpr Foam::scalar longest = 10;

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Foam::fsi::namedSolver> Foam::fsi::solvers
(
    const bool constantCoefficients
)
{
    std::vector<namedSolver> result
    {
        {"GAMG", "solver GAMG; smoother GaussSeidel;"},
        {
            "PCG GAMG",
            "solver PCG;"
            " preconditioner { preconditioner GAMG; smoother GaussSeidel; }"
        },
        {"cartesianMG", "solver cartesianMG;"},
        {"cartesianMG V", "solver cartesianMG; wCycleCells 1;"},
        {"PCG cartesianMG", "solver PCG; preconditioner cartesianMG;"}
    };
    if (constantCoefficients)
    {
        result.push_back({"cartesianFFT", "solver cartesianFFT;"});
    }
    const auto others = [](const namedSolver& solver)
    {
        return !wanted.empty() && wanted != solver.name;
    };
    result.erase
    (
        std::remove_if(result.begin(), result.end(), others), result.end()
    );
    return result;
}


Foam::fsi::measurement Foam::fsi::measure
(
    poissonProblem& problem,
    const namedSolver& solver,
    const scalar tolerance,
    const label repeats
)
{
    const string controls
    (
        string(solver.controls) + " tolerance " + name(tolerance)
      + "; relTol 0;"
    );
    measurement found{problem.solve(controls), 0, 0};
    found.firstSeconds = found.result.seconds;
    std::vector<scalar> seconds;
    scalar total = found.firstSeconds;
    for (label i = 0; i < repeats && total < longest; ++i)
    {
        seconds.push_back(problem.solve(controls).seconds);
        total += seconds.back();
    }
    std::sort(seconds.begin(), seconds.end());
    found.seconds =
        seconds.empty() ? found.firstSeconds : seconds[seconds.size()/2];
    return found;
}


bool Foam::fsi::printRows
(
    poissonProblem& problem,
    const std::string& start,
    const bool constantCoefficients,
    const label repeats
)
{
    // The error that a residual of 1e-6 leaves depends on the mesh: all
    // solvers may have a few times that of GAMG
    scalar seconds = 0;
    scalar error = 0;
    bool passed = true;
    for (const namedSolver& solver : solvers(constantCoefficients))
    {
        const measurement found = measure(problem, solver, 1e-6, repeats);
        const scalar d = difference(found.result.p, problem.exact());
        const bool first = seconds == 0;
        seconds = first ? found.seconds : seconds;
        error = first ? d : error;
        passed =
            passed
         && (first || (found.result.converged && d < max(10*error, 1e-6)));
        if (Pstream::master())
        {
            std::printf
            (
                "%s,%s,%d,%d,%.4g,%.4g,%.3f,%.2g\n",
                start.c_str(), solver.name, Pstream::nProcs(),
                found.result.nIterations, found.seconds, found.firstSeconds,
                found.seconds/seconds, d
            );
            std::fflush(stdout);
        }
    }
    return passed;
}


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace Foam;

    fsi::printTablesOnly();
    fsi::addArgument("table");
    fsi::addArgument("cells");
    fsi::addArgument("repeats");
    argList::addOption("solver", "name", "use this solver only");
    argList args(argc, argv, true, false);

    // Solvers' own lines are not wanted
    solverPerformance::debug = 0;

    const word table(args[1]);
    const label n = fsi::argumentOf<label>(args, 2);
    const label repeats = fsi::argumentOf<label>(args, 3);
    wanted = fsi::optionOr<string>(args, "solver", "");
    const bool passed =
        table == "patches2D" ? fsi::patchTable(2, n, repeats)
      : table == "patches3D" ? fsi::patchTable(3, n, repeats)
      : table == "discs" ? fsi::discTable(n, repeats)
      : false;
    if (!passed)
    {
        Info<< "poissonTables: failed" << endl;
    }
    return passed ? 0 : 1;
}


// ************************************************************************* //
