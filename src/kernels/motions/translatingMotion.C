// SPDX-License-Identifier: GPL-3.0-or-later

#include "translatingMotion.H"
#include "readBetween.H"
#include "addToRunTimeSelectionTable.H"

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
    bodyMotion(dict, {"velocity"}),
    velocity_(readFinite(dict, "velocity"))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::translatingMotion::displacement
(
    const scalar clock
) const
{
    return clock*velocity_;
}


Foam::vector Foam::fsi::translatingMotion::rotation(const scalar clock) const
{
    return Zero;
}


// ************************************************************************* //
