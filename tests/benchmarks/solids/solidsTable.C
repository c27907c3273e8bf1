// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Program
    solidsTable

Description
    Prints, as CSV, what a step of the solids costs and how exact it is: copies
    of a disc of some 258 nodes, squeezed and bent for 20 steps by forces on
    their surface, without a fluid; or how stiff bodies in 3D are (solidTables).

    reach: l/h = dt sqrt(E/rho)/h, how many node spacings a step's waves go.
    change: A^-1 r of the last iteration over the node spacing, the largest of
    all copies and steps. error: in the positions after 20 steps, from those of
    a converged iteration, over the largest displacement. Time: processor time
    of the prediction per object and step, median of the steps.

Usage
    solidsTable [COPIES]        default 640
    solidsTable locking         compliance of a sphere, over the exact one
    solidsTable bending         compliance of a bar in bending, the same
    solidsTable iterations      error of a step of a bar by its iterations
\*---------------------------------------------------------------------------*/

#include "admmSolver.H"
#include "samples/samples.H"
#include "solidTables.H"
#include "SortableList.H"

#include <cstdio>
#include <ctime>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar spacing = 0.0118;
const label nSteps = 20;


//- A tenth of E as a stress that squeezes, and bends
Eigen::MatrixXd load(const bodyGroup& group)
{
    const shapeTemplate& shape = group.shape();
    const scalar size =
        0.1*shape.youngsModulus()*shape.thickness()*shape.nodeSpacing();
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero
    (
        shape.nNodes(),
        2*group.size()
    );
    for (label copyi = 0; copyi < group.size(); ++copyi)
    {
        for (label i = 0; i < shape.nBoundaryNodes(); ++i)
        {
            const scalar x = shape.points()[i].x()/0.1;
            const scalar y = shape.points()[i].y()/0.1;
            force(i, 2*copyi) = size*x;
            force(i, 2*copyi + 1) = -size*(y + 2*(sqr(x) - 0.25));
        }
    }
    return force;
}


//- Result of a run
struct outcome
{
    Eigen::MatrixXd positions;
    scalar seconds;
    label iterations;
    scalar change;
};


outcome solve(const string& admm, const scalar reach, const label nCopies)
{
    const auto shape = disc("density 1000; E 1e4;", admm, spacing);
    const auto group = groupOf(*shape);
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        group->append(Zero, tensor::I, Zero, Zero, copyi);
    }
    const scalar dt = reach*spacing/std::sqrt(1e4/1000);
    const Eigen::MatrixXd force = load(*group);

    outcome result{{}, 0, 0, 0};
    SortableList<scalar> seconds(nSteps);
    admmSolver solver(*shape);
    Eigen::MatrixXd v;
    for (label step = 0; step < nSteps; ++step)
    {
        const std::clock_t begin = std::clock();
        solver.solve
        (
            dt,
            {group->positions(), group->velocities(), force, {}},
            v
        );
        seconds[step] = scalar(std::clock() - begin)/CLOCKS_PER_SEC;
        group->prepareResponse(dt);
        group->move(dt, v);
        result.iterations = max(result.iterations, solver.nIterations());
        result.change = max(result.change, solver.lastChange());
    }
    seconds.sort();
    result.positions = group->positions().leftCols(2);
    result.seconds = seconds[nSteps/2]/nCopies;
    return result;
}


void printRow
(
    const word& scheme,
    const label iterations,
    const scalar reach,
    const label nCopies,
    const outcome& exact,
    const Eigen::MatrixXd& start
)
{
    const outcome found = solve
    (
        "scheme " + scheme + "; iterations " + Foam::name(iterations) + ";",
        reach,
        nCopies
    );
    const scalar displacement =
        (exact.positions - start).cwiseAbs().maxCoeff();
    const scalar error =
        (found.positions - exact.positions).cwiseAbs().maxCoeff();
    std::printf
    (
        "%s,%d,%g,%d,%.1f,%.1e,%.4f\n",
        scheme.c_str(),
        int(found.iterations),
        reach,
        int(start.rows()),
        1e6*found.seconds,
        found.change,
        error/displacement
    );
    std::fflush(stdout);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    const word table(argc > 1 ? argv[1] : "640");
    if (table == "locking" || table == "bending" || table == "iterations")
    {
        solidTables::print(table);
        return 0;
    }
    const label nCopies = std::atoi(table.c_str());
    const auto shape = disc("density 1000; E 1e4;", "", spacing);
    const auto group = groupOf(*shape);
    group->append(Zero, tensor::I, Zero, Zero, 0);

    std::puts("scheme,iterations,reach,nodes,us per object,change,error");
    for (const scalar reach : {0.2, 0.7, 3.0})
    {
        const outcome exact =
            solve
            (
                "scheme quasiNewton; iterations 2000; tolerance 1e-12;",
                reach,
                1
            );
        for (const label iterations : {5, 10, 20})
        {
            printRow
            (
                "ADMM", iterations, reach, nCopies, exact, group->positions()
            );
        }
        for (const label iterations : {4, 6, 8, 10})
        {
            printRow
            (
                "quasiNewton", iterations, reach, nCopies, exact,
                group->positions()
            );
        }
    }
    return 0;
}


// ************************************************************************* //
