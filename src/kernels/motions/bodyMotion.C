// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(bodyMotion, 0);
    defineRunTimeSelectionTable(bodyMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::bodyMotion> Foam::fsi::bodyMotion::New
(
    const dictionary& dict
)
{
    const word motionType(dict.lookupOrDefault<word>("type", "free"));
    if (motionType == "free")
    {
        checkKeys(dict, {"type"});
        return autoPtr<bodyMotion>();
    }

    const auto* constructor =
        findIn(*dictionaryConstructorTablePtr_, motionType);
    if (!constructor)
    {
        wordList valid(dictionaryConstructorTablePtr_->sortedToc());
        valid.append("free");
        FatalIOErrorInFunction(dict)
            << "Unknown entry 'type' " << motionType << " in dictionary "
            << dict.name() << nl << "Valid motions are " << valid
            << exit(FatalIOError);
    }
    return (*constructor)(dict);
}


// ************************************************************************* //
