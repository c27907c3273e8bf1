// SPDX-License-Identifier: GPL-3.0-or-later

#include "lubrication.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(lubrication, 0);
    defineRunTimeSelectionTable(lubrication, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::lubrication> Foam::fsi::lubrication::New
(
    const dictionary& dict,
    const contactScales& scales
)
{
    const word type(dict.lookupOrDefault<word>("type", "none"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, dict, typeName, type
    )(dict, scales);
}


// ************************************************************************* //
