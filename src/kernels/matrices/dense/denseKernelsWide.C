// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseKernels.H"

#include <algorithm>
#include <cmath>

// All that follows is compiled for registers of eight doubles. Nothing of it is
// called from elsewhere but what denseKernels.H names
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    #pragma GCC target("avx512f")
#endif

#include "denseFactorTiles.H"
#include "denseSolveTiles.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::factorWide
(
    double* values,
    const label first,
    const label last
)
{
    return factorPanels<wideTiles>(values, first, last);
}


void Foam::fsi::solveWide
(
    const double* values,
    const label nPanels,
    const label nColumns,
    double* x
)
{
    solveColumns<wideTiles::column>(values, nPanels, nColumns, x);
}


void Foam::fsi::multiplyWide
(
    const double* rows,
    const label nPanels,
    const double* columns,
    const label nTerms,
    double* result
)
{
    multiplyPanels<wideTiles>(rows, nPanels, columns, nTerms, result);
}


// ************************************************************************* //
