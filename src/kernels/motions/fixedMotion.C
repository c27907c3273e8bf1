// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixedMotion.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

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
{
    checkKeys(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::fixedMotion::displacement(const scalar time) const
{
    return Zero;
}


Foam::vector Foam::fsi::fixedMotion::rotation(const scalar time) const
{
    return Zero;
}


// ************************************************************************* //
