// SPDX-License-Identifier: GPL-3.0-or-later

#include "Hookean.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(Hookean, 0);
    addToRunTimeSelectionTable(springLaw, Hookean, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::Hookean::Hookean(const dictionary& dict, const scalar)
{
    checkKeys(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::Hookean::stiffnessRatio(const scalar) const
{
    return 1;
}


void Foam::fsi::Hookean::restLengths
(
    const label n,
    const scalar restLength,
    const scalar*,
    const scalar*,
    const scalar,
    scalar* result
) const
{
    for (label i = 0; i < n; ++i)
    {
        result[i] = restLength;
    }
}


// ************************************************************************* //
