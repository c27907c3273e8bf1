// SPDX-License-Identifier: GPL-3.0-or-later

// Iterations of cartesianMG must hardly depend on how many discs the walls
// are made of, for voxels (faces open or closed) and open areas; cells and
// coefficients as in a flow around discs that cover 41 % of a square

#include <gtest/gtest.h>
#include "poissonProblem.H"
#include "poissonCases.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Iterations to 1e-6 with nRow^2 discs on n^2 cells
label iterations
(
    const label n,
    const label nRow,
    const bool voxel,
    const label wCycleCells = labelMax
)
{
    latticeOptions options;
    options.n = labelVector(n, n, 1);
    latticeMesh mesh(options);
    poissonProblem problem(mesh, {});
    if (nRow > 0)
    {
        maskByDiscs(problem, n, nRow, voxel);
    }
    const poissonResult result = problem.solve
    (
        "solver cartesianMG; tolerance 1e-6; relTol 0; wCycleCells "
      + std::to_string(wCycleCells) + ';'
    );
    EXPECT_TRUE(result.converged);
    return result.nIterations;
}

} // End namespace


TEST(maskedWalls, iterationsHardlyDependOnTheNumberOfDiscs)
{
    for (const bool voxel : {true, false})
    {
        label least = labelMax;
        label most = 0;
        for (const label nRow : {0, 1, 4, 10, 12})
        {
            const label n = iterations(256, nRow, voxel);
            RecordProperty("discs" + std::to_string(nRow*nRow), n);
            Info<< (voxel ? "voxel " : "open area ") << nRow*nRow
                << " discs: " << n << endl;
            least = min(least, n);
            most = max(most, n);
        }
        EXPECT_LE(most - least, 3);

        // Discs of nine cells, with gaps of one or two
        EXPECT_LE(iterations(256, 20, voxel), 12);
    }
}


TEST(maskedWalls, aThousandDiscs)
{
    // Voxels: at most three iterations between 0, 100 and 1,024 discs on 640^2
    // cells. Open areas, gaps of three cells with slivers at their sides, take
    // up to ten; as many as discs of nine cells, above
    label least = labelMax;
    label most = 0;
    for (const label nRow : {0, 10, 32})
    {
        const label n = iterations(640, nRow, true);
        least = min(least, n);
        most = max(most, n);
    }
    EXPECT_LE(most - least, 3);
    EXPECT_LE(iterations(640, 32, false), 12);
}


TEST(maskedWalls, VCycleToo)
{
    for (const bool voxel : {true, false})
    {
        for (const label nRow : {1, 10})
        {
            EXPECT_LE(iterations(192, nRow, voxel, 1), 18);
        }
    }
}


// ************************************************************************* //
