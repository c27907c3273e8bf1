// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneLaw.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(membraneLaw, 0);
    defineRunTimeSelectionTable(membraneLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::membraneLaw> Foam::fsi::membraneLaw::New
(
    const dictionary& dict
)
{
    return constructorOf
    (
        *dictionaryConstructorTablePtr_,
        dict,
        "law",
        dict.lookupOrDefault<word>("law", "Skalak")
    )(dict);
}


// ************************************************************************* //
