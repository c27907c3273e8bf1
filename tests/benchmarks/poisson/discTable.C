// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonTables.H"
#include <cstdio>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::discTable(const label n, const label repeats)
{
    if (Pstream::master())
    {
        std::printf
        (
            "cells,wall,discs,solver,ranks,iterations,seconds,first,"
            "ratio to GAMG,error\n"
        );
    }
    latticeOptions options;
    options.n = labelVector(n, n, 1);
    latticeMesh mesh(options);
    bool passed = true;
    for (const bool voxel : {true, false})
    {
        for (const label nRow : {0, 1, 10, 32})
        {
            poissonProblem problem(mesh, {});
            if (nRow > 0)
            {
                maskByDiscs(problem, n, nRow, voxel);
            }
            const std::string name
            (
                std::to_string(n) + "^2," + (voxel ? "voxel," : "openArea,")
              + std::to_string(nRow*nRow)
            );
            passed = printRows(problem, name, nRow == 0, repeats) && passed;
        }
    }
    return passed;
}


// ************************************************************************* //
