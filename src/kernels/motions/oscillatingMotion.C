// SPDX-License-Identifier: GPL-3.0-or-later

#include "oscillatingMotion.H"
#include "readBetween.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(oscillatingMotion, 0);
    addToRunTimeSelectionTable(bodyMotion, oscillatingMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::oscillatingMotion::oscillatingMotion(const dictionary& dict)
:
    amplitude_(readFinite(dict, "amplitude")),
    frequency_(readPositive(dict, "frequency"))
{
    checkKeys(dict, {"type", "amplitude", "frequency"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::oscillatingMotion::displacement(const scalar time) const
{
    return amplitude_*std::sin(constant::mathematical::twoPi*frequency_*time);
}


Foam::vector Foam::fsi::oscillatingMotion::rotation(const scalar time) const
{
    return Zero;
}


// ************************************************************************* //
