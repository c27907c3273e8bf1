// SPDX-License-Identifier: GPL-3.0-or-later

#include "attractiveContact.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::attractiveContact::attractiveContact
(
    const dictionary& dict,
    const contactScales& scales
)
:
    elasticContact
    (
        dict,
        scales,
        readPositive(dict, "equilibriumGap", 1)*scales.spacing
    ),
    cutOff_(scales.range),
    depth_(readPositive(dict, "adhesionEnergy")),
    equilibriumGap_(readPositive(dict, "equilibriumGap", 1)*scales.spacing)
{
    if (equilibriumGap_ >= cutOff_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'equilibriumGap' in dictionary " << dict.name()
            << " gives the gap " << equilibriumGap_
            << " but must be below the range of contact, " << cutOff_
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::fsi::attractiveContact::keys(const wordList& own)
{
    wordList all
    (
        potentialContact::keys
        (
            {"stiffness", "adhesionEnergy", "equilibriumGap"}
        )
    );
    all.append(own);
    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::attractiveContact::repulsion(const scalar gap) const
{
    return
        elasticContact::repulsion(gap)
      + repellingPressure(gap) - repellingPressure(cutOff_);
}


Foam::scalar
Foam::fsi::attractiveContact::repulsionSlope(const scalar gap) const
{
    return elasticContact::repulsionSlope(gap) + repellingSlope(gap);
}


Foam::scalar
Foam::fsi::attractiveContact::repulsionEnergy(const scalar gap) const
{
    return
        elasticContact::repulsionEnergy(gap)
      + repellingEnergy(gap) - repellingEnergy(cutOff_)
      + repellingPressure(cutOff_)*(gap - cutOff_);
}


Foam::scalar Foam::fsi::attractiveContact::attraction(const scalar gap) const
{
    return attractingPressure(gap) - attractingPressure(cutOff_);
}


Foam::scalar
Foam::fsi::attractiveContact::attractionEnergy(const scalar gap) const
{
    return
        attractingEnergy(gap) - attractingEnergy(cutOff_)
      - attractingPressure(cutOff_)*(gap - cutOff_);
}


// ************************************************************************* //
