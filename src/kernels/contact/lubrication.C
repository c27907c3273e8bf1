// SPDX-License-Identifier: GPL-3.0-or-later

#include "lubrication.H"

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
    const auto iter = dictionaryConstructorTablePtr_->cfind(type);
    if (!iter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            typeName,
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return autoPtr<lubrication>(iter()(dict, scales));
}


// ************************************************************************* //
