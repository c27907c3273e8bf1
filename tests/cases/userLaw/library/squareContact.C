// SPDX-License-Identifier: GPL-3.0-or-later

#include "squareContact.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(squareContact, 0);

    namespace fsi
    {
        addToRunTimeSelectionTable(contactLaw, squareContact, dictionary);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::squareContact::squareContact
(
    const dictionary& dict,
    const fsi::contactScales& scales
)
:
    potentialContact(dict, scales),
    stiffness_(fsi::readPositive(dict, "stiffness")),
    range_(scales.range)
{
    fsi::checkKeys(dict, keys({"stiffness"}));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::squareContact::repulsion(const scalar gap) const
{
    return stiffness_*sqr(max(1 - gap/range_, 0.0));
}


Foam::scalar Foam::squareContact::repulsionSlope(const scalar gap) const
{
    return -2*stiffness_/range_*max(1 - gap/range_, 0.0);
}


Foam::scalar Foam::squareContact::repulsionEnergy(const scalar gap) const
{
    return stiffness_*range_/3*pow3(max(1 - gap/range_, 0.0));
}


// ************************************************************************* //
