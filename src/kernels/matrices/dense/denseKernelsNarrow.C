// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseFactorTiles.H"
#include "denseSolveTiles.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

FSI_AVX2_CLONES
bool Foam::fsi::factorNarrow
(
    double* values,
    const label first,
    const label last
)
{
    return factorPanels<narrowTiles>(values, first, last);
}


FSI_AVX2_CLONES
void Foam::fsi::solveNarrow
(
    const double* values,
    const label nPanels,
    const label nColumns,
    double* x
)
{
    solveColumns<narrowTiles::column>(values, nPanels, nColumns, x);
}


FSI_AVX2_CLONES
void Foam::fsi::multiplyNarrow
(
    const double* rows,
    const label nPanels,
    const double* columns,
    const label nTerms,
    double* result
)
{
    multiplyPanels<narrowTiles>(rows, nPanels, columns, nTerms, result);
}


// ************************************************************************* //
