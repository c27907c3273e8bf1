// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonTables.H"
#include <algorithm>
#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

//- Kinds of conditions at the two sides of a direction
const char* const kinds[] = {"gradient", "mixed", "value", "cyclic"};

//- Kinds of all directions in rising order: the others are rotations
std::vector<std::vector<label>> combinations(const label nDims)
{
    std::vector<std::vector<label>> result;
    for (label x = 0; x < 4; ++x)
    {
        for (label y = x; y < 4; ++y)
        {
            for (label z = (nDims > 2 ? y : 3); z < 4; ++z)
            {
                result.push_back
                (
                    nDims > 2
                  ? std::vector<label>({x, y, z})
                  : std::vector<label>({x, y})
                );
            }
        }
    }
    return result;
}


//- Names of the patches with a value
wordList fixedPatches(const std::vector<label>& combination)
{
    static const char* const low[] = {"xMin", "yMin", "zMin"};
    static const char* const high[] = {"xMax", "yMax", "zMax"};
    DynamicList<word> fixed;
    for (std::size_t d = 0; d < combination.size(); ++d)
    {
        if (combination[d] == 1 || combination[d] == 2)
        {
            fixed.append(low[d]);
        }
        if (combination[d] == 2)
        {
            fixed.append(high[d]);
        }
    }
    return wordList(fixed);
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::patchTable
(
    const label nDims,
    const label n,
    const label repeats
)
{
    if (Pstream::master())
    {
        std::printf
        (
            "cells,patches,solver,ranks,iterations,seconds,first,"
            "ratio to GAMG,error\n"
        );
    }
    bool passed = true;

    // Meshes are made once for each set of cyclic directions
    for (label nCyclic = 0; nCyclic <= nDims; ++nCyclic)
    {
        latticeOptions options;
        options.n = labelVector(n, n, nDims > 2 ? n : 1);
        options.emptyDirection = nDims > 2 ? 3 : 2;
        options.spacing = vector(1, 1, 1)/n;
        for (label d = nDims - nCyclic; d < nDims; ++d)
        {
            options.cyclic[d] = true;
        }
        latticeMesh mesh(options);
        for (const std::vector<label>& combination : combinations(nDims))
        {
            const label count =
                std::count(combination.begin(), combination.end(), 3);
            if (count == nCyclic)
            {
                std::string name
                (
                    std::to_string(n) + '^' + std::to_string(nDims)
                );
                char separator = ',';
                for (const label kind : combination)
                {
                    name += separator + std::string(kinds[kind]);
                    separator = ' ';
                }
                poissonProblem problem(mesh, fixedPatches(combination));
                passed = printRows(problem, name, true, repeats) && passed;
            }
        }
    }
    return passed;
}


// ************************************************************************* //
