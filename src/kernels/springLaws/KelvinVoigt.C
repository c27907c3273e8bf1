// SPDX-License-Identifier: GPL-3.0-or-later

#include "KelvinVoigt.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(KelvinVoigt, 0);
    addToRunTimeSelectionTable(springLaw, KelvinVoigt, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::KelvinVoigt::KelvinVoigt
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

Foam::scalar Foam::fsi::KelvinVoigt::stiffnessRatio(const scalar dt) const
{
    return 1 + time_/dt;
}


void Foam::fsi::KelvinVoigt::restLengths
(
    const label n,
    const scalar restLength,
    const scalar* length,
    const scalar*,
    const scalar dt,
    scalar* result
) const
{
    // Written so that a spring at rest has exactly its rest length
    const scalar fraction = time_/(time_ + dt);
    for (label i = 0; i < n; ++i)
    {
        result[i] = restLength + fraction*(length[i] - restLength);
    }
}


// ************************************************************************* //
