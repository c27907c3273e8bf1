// SPDX-License-Identifier: GPL-3.0-or-later

#include "Maxwell.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(Maxwell, 0);
    addToRunTimeSelectionTable(springLaw, Maxwell, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::Maxwell::Maxwell
(
    const dictionary& dict,
    const scalar youngsModulus
)
:
    time_(readPositive(dict, "viscosity")/youngsModulus)
{
    checkKeys(dict, {"type", "viscosity"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::Maxwell::stiffnessRatio(const scalar dt) const
{
    return time_/(time_ + dt);
}


void Foam::fsi::Maxwell::restLengths
(
    const label n,
    const scalar restLength,
    const scalar*,
    const scalar* state,
    const scalar,
    scalar* result
) const
{
    for (label i = 0; i < n; ++i)
    {
        result[i] = restLength + state[i];
    }
}


Foam::scalar Foam::fsi::Maxwell::advanceState
(
    const scalar restLength,
    const scalar length,
    const scalar state,
    const scalar dt
) const
{
    return state + (length - restLength - state)*dt/(time_ + dt);
}


Foam::scalar Foam::fsi::Maxwell::relaxedLength
(
    const scalar restLength,
    const scalar state
) const
{
    return restLength + state;
}


// ************************************************************************* //
