// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactLaw.H"
#include "dictionary.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(contactLaw, 0);
    defineRunTimeSelectionTable(contactLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::contactLaw> Foam::fsi::contactLaw::New
(
    const dictionary& dict,
    const contactScales& scales
)
{
    const word type(dict.lookupOrDefault<word>("type", "elastic"));
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
    return autoPtr<contactLaw>(iter()(dict, scales));
}


// ************************************************************************* //
