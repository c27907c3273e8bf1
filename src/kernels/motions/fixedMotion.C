// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixedMotion.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(fixedMotion, 0);
    addToRunTimeSelectionTable(bodyMotion, fixedMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fixedMotion::fixedMotion(const dictionary& dict)
:
    bodyMotion(dict, wordList())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::fixedMotion::displacement(const scalar clock) const
{
    return Zero;
}


Foam::vector Foam::fsi::fixedMotion::rotation(const scalar clock) const
{
    return Zero;
}


// ************************************************************************* //
