// SPDX-License-Identifier: GPL-3.0-or-later

#include "solverKeys.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::wordList& Foam::fsi::solverKeys()
{
    static const wordList keys
    ({
        "solver", "preconditioner", "smoother", "type", "tolerance", "relTol",
        "minIter", "maxIter", "log", "norm", "wCycleCells",
        "gatherCells",
        // Of OpenFOAM's smoothers and GAMG
        "nSweeps", "agglomerator", "mergeLevels", "nCellsInCoarsestLevel",
        "cacheAgglomeration", "nPreSweeps", "preSweepsLevelMultiplier",
        "maxPreSweeps", "nPostSweeps", "postSweepsLevelMultiplier",
        "maxPostSweeps", "nFinestSweeps", "nVcycles", "interpolateCorrection",
        "scaleCorrection", "directSolveCoarsest", "coarsestLevelCorr",
        "processorAgglomerator", "nAgglomeratingCells"
    });
    return keys;
}


void Foam::fsi::checkSolverKeys(const dictionary& controls)
{
    for (const entry& e : controls)
    {
        const keyType& key = e.keyword();
        if (!key.isPattern() && !isIn(solverKeys(), word(key)))
        {
            FatalIOErrorInFunction(controls)
                << "Unknown entry '" << key << "' in dictionary "
                << controls.name() << nl << "Valid entries are "
                << flatOutput(solverKeys()) << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
