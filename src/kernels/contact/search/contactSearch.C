// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactSearch.H"
#include "Switch.H"
#include "dictionaryCheck.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(contactSearch, 0);
    defineRunTimeSelectionTable(contactSearch, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contactSearch::contactSearch(const dictionary& dict)
:
    geometry_(dict.lookupOrDefault<Switch>("selfContact", true))
{
    checkKeys(dict, {"type", "selfContact"});
}


Foam::autoPtr<Foam::fsi::contactSearch> Foam::fsi::contactSearch::New
(
    const dictionary& dict
)
{
    const word type(readName(dict, "type", "surfaceTree"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, dict, typeName, type
    )(dict);
}


// ************************************************************************* //
