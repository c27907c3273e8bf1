// SPDX-License-Identifier: GPL-3.0-or-later

#include "translatingMotion.H"
#include "readBetween.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(translatingMotion, 0);
    addToRunTimeSelectionTable(bodyMotion, translatingMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::translatingMotion::translatingMotion(const dictionary& dict)
:
    velocity_(readFinite(dict, "velocity"))
{
    checkKeys(dict, {"type", "velocity"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::translatingMotion::displacement(const scalar time) const
{
    return time*velocity_;
}


Foam::vector Foam::fsi::translatingMotion::rotation(const scalar time) const
{
    return Zero;
}


// ************************************************************************* //
