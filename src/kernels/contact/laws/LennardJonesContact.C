// SPDX-License-Identifier: GPL-3.0-or-later

#include "LennardJonesContact.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(LennardJonesContact, 0);
    addToRunTimeSelectionTable(contactLaw, LennardJonesContact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::LennardJonesContact::LennardJonesContact
(
    const dictionary& dict,
    const contactScales& scales
)
:
    attractiveContact(dict, scales)
{
    checkKeys(dict, keys({}));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::LennardJonesContact::curvature
(
    const scalar gap,
    const label n
) const
{
    const scalar g = max(gap, 0.5*equilibriumGap_);
    return n*(n + 1)*pow(equilibriumGap_/g, n)/sqr(g);
}


Foam::scalar Foam::fsi::LennardJonesContact::power
(
    const scalar gap,
    const label n,
    scalar& slope
) const
{
    const scalar g = max(gap, 0.5*equilibriumGap_);
    const scalar value = pow(equilibriumGap_/g, n);
    const scalar below = gap - g;
    const scalar bend = curvature(gap, n)*below;

    slope = -n*value/g + bend;
    return value + below*(slope - 0.5*bend);
}


Foam::scalar
Foam::fsi::LennardJonesContact::repellingEnergy(const scalar gap) const
{
    scalar slope;
    return depth_*power(gap, 12, slope);
}


Foam::scalar
Foam::fsi::LennardJonesContact::repellingPressure(const scalar gap) const
{
    scalar slope;
    power(gap, 12, slope);
    return -depth_*slope;
}


Foam::scalar
Foam::fsi::LennardJonesContact::repellingSlope(const scalar gap) const
{
    return -depth_*curvature(gap, 12);
}


Foam::scalar
Foam::fsi::LennardJonesContact::attractingEnergy(const scalar gap) const
{
    scalar slope;
    return -2*depth_*power(gap, 6, slope);
}


Foam::scalar
Foam::fsi::LennardJonesContact::attractingPressure(const scalar gap) const
{
    scalar slope;
    power(gap, 6, slope);
    return -2*depth_*slope;
}


// ************************************************************************* //
