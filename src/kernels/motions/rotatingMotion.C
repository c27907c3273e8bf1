// SPDX-License-Identifier: GPL-3.0-or-later

#include "rotatingMotion.H"
#include "readBetween.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(rotatingMotion, 0);
    addToRunTimeSelectionTable(bodyMotion, rotatingMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rotatingMotion::rotatingMotion(const dictionary& dict)
:
    angularVelocity_(readFinite(dict, "angularVelocity"))
{
    checkKeys(dict, {"type", "angularVelocity"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::rotatingMotion::displacement(const scalar time) const
{
    return Zero;
}


Foam::vector Foam::fsi::rotatingMotion::rotation(const scalar time) const
{
    return time*angularVelocity_;
}


// ************************************************************************* //
