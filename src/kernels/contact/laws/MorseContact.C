// SPDX-License-Identifier: GPL-3.0-or-later

#include "MorseContact.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(MorseContact, 0);
    addToRunTimeSelectionTable(contactLaw, MorseContact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::MorseContact::MorseContact
(
    const dictionary& dict,
    const contactScales& scales
)
:
    attractiveContact(dict, scales),
    decay_(1/(readScalarBetween(dict, "width", 0.5, 0.05, 100)*scales.spacing))
{
    checkKeys(dict, keys({"width"}));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::MorseContact::repellingEnergy(const scalar gap) const
{
    return depth_*exp(-2*decay_*(gap - equilibriumGap_));
}


Foam::scalar Foam::fsi::MorseContact::repellingPressure(const scalar gap) const
{
    return 2*decay_*repellingEnergy(gap);
}


Foam::scalar Foam::fsi::MorseContact::repellingSlope(const scalar gap) const
{
    return -4*sqr(decay_)*repellingEnergy(gap);
}


Foam::scalar Foam::fsi::MorseContact::attractingEnergy(const scalar gap) const
{
    return -2*depth_*exp(-decay_*(gap - equilibriumGap_));
}


Foam::scalar
Foam::fsi::MorseContact::attractingPressure(const scalar gap) const
{
    return -decay_*attractingEnergy(gap);
}


// ************************************************************************* //
