// SPDX-License-Identifier: GPL-3.0-or-later

#include "elasticContact.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(elasticContact, 0);
    addToRunTimeSelectionTable(contactLaw, elasticContact, dictionary);

    //- Gap over the range below which the pressure is linear
    static const scalar linearBelow = 0.01;
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::elasticContact::elasticContact
(
    const dictionary& dict,
    const contactScales& scales,
    const scalar reach,
    const scalar stiffness,
    const bool onRigid
)
:
    potentialContact(dict, scales),
    stiffness_(stiffness),
    reach_(reach),
    onRigid_(onRigid)
{}


Foam::fsi::elasticContact::elasticContact
(
    const dictionary& dict,
    const contactScales& scales
)
:
    elasticContact
    (
        dict,
        scales,
        scales.range,
        scales.youngsModulus > 0 || dict.found("stiffness")
      ? scales.stiffness(dict)
      : 0,
        dict.found("stiffness")
    )
{
    checkKeys(dict, keys({"stiffness"}));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::elasticContact::repulsion(const scalar gap) const
{
    const scalar s = max(gap/reach_, linearBelow);
    return
        s >= 1
      ? 0
      : stiffness_*sqr(1/s - 1)
      + min(gap - s*reach_, 0)*elasticContact::repulsionSlope(gap);
}


Foam::scalar Foam::fsi::elasticContact::repulsionSlope(const scalar gap) const
{
    const scalar s = max(gap/reach_, linearBelow);
    return s >= 1 ? 0 : -2*stiffness_*(1/s - 1)/(sqr(s)*reach_);
}


Foam::scalar Foam::fsi::elasticContact::repulsionEnergy(const scalar gap) const
{
    const scalar s = max(gap/reach_, linearBelow);
    if (s >= 1)
    {
        return 0;
    }

    // Below the linear part's end: the mean pressure times the distance
    const scalar below = min(gap - s*reach_, 0);
    const scalar slope = elasticContact::repulsionSlope(gap);
    return
        stiffness_*reach_*(1/s - s + 2*log(s))
      - below*(stiffness_*sqr(1/s - 1) + 0.5*below*slope);
}


// ************************************************************************* //
