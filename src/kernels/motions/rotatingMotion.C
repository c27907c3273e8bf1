// SPDX-License-Identifier: GPL-3.0-or-later

#include "rotatingMotion.H"
#include "readBetween.H"
#include "addToRunTimeSelectionTable.H"

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
    bodyMotion(dict, {"angularVelocity"}),
    angularVelocity_(readFinite(dict, "angularVelocity"))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::rotatingMotion::displacement(const scalar clock) const
{
    return Zero;
}


Foam::vector Foam::fsi::rotatingMotion::rotation(const scalar clock) const
{
    return clock*angularVelocity_;
}


// ************************************************************************* //
