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
    elasticContact
    (
        dict,
        scales,
        readPositive(dict, "equilibriumGap", 1)*scales.spacing,
        scales.stiffness(dict)
    ),
    cutOff_(scales.range),
    depth_(readPositive(dict, "adhesionEnergy")),
    equilibriumGap_(readPositive(dict, "equilibriumGap", 1)*scales.spacing),
    decay_(1/(readScalarBetween(dict, "width", 0.5, 0.05, 100)*scales.spacing))
{
    if (equilibriumGap_ >= cutOff_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'equilibriumGap' in dictionary " << dict.name()
            << " gives the gap " << equilibriumGap_
            << " but must be below the range of contact, " << cutOff_
            << exit(FatalIOError);
    }
    checkKeys
    (
        dict,
        potentialContact::keys
        (
            {"stiffness", "adhesionEnergy", "equilibriumGap", "width"}
        )
    );
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


Foam::scalar Foam::fsi::MorseContact::attractingEnergy(const scalar gap) const
{
    return -2*depth_*exp(-decay_*(gap - equilibriumGap_));
}


Foam::scalar
Foam::fsi::MorseContact::attractingPressure(const scalar gap) const
{
    return -decay_*attractingEnergy(gap);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::MorseContact::repulsion(const scalar gap) const
{
    return
        elasticContact::repulsion(gap)
      + repellingPressure(gap) - repellingPressure(cutOff_);
}


Foam::scalar Foam::fsi::MorseContact::repulsionSlope(const scalar gap) const
{
    return
        elasticContact::repulsionSlope(gap)
      - 4*sqr(decay_)*repellingEnergy(gap);
}


Foam::scalar Foam::fsi::MorseContact::repulsionEnergy(const scalar gap) const
{
    return
        elasticContact::repulsionEnergy(gap)
      + repellingEnergy(gap) - repellingEnergy(cutOff_)
      + repellingPressure(cutOff_)*(gap - cutOff_);
}


Foam::scalar Foam::fsi::MorseContact::attraction(const scalar gap) const
{
    return attractingPressure(gap) - attractingPressure(cutOff_);
}


Foam::scalar Foam::fsi::MorseContact::attractionEnergy(const scalar gap) const
{
    return
        attractingEnergy(gap) - attractingEnergy(cutOff_)
      - attractingPressure(cutOff_)*(gap - cutOff_);
}


// ************************************************************************* //
