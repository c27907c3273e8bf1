// SPDX-License-Identifier: GPL-3.0-or-later

#include "rebuiltLevelSet.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(rebuiltLevelSet, 0);
    addToRunTimeSelectionTable(levelSetUpdate, rebuiltLevelSet, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rebuiltLevelSet::rebuiltLevelSet
(
    const cartesianMesh& grid,
    const dictionary& dict
)
:
    levelSetUpdate(grid, dict)
{
    checkKeys(dict, {"type", "bandWidth"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::rebuiltLevelSet::initialise(const surfaceSet& surfaces)
{
    setFromSurfaces(surfaces);
}


void Foam::fsi::rebuiltLevelSet::move
(
    const surfaceSet& surfaces,
    const scalar
)
{
    setFromSurfaces(surfaces);
    ++nRebuilds_;
}


// ************************************************************************* //
