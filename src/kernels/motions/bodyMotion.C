// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"
#include "dictionaryCheck.H"

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
        return nullptr;
    }

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(motionType);
    if (!cstrIter.found())
    {
        wordList valid(dictionaryConstructorTablePtr_->sortedToc());
        valid.append("free");
        FatalIOErrorInFunction(dict)
            << "Unknown entry 'type' " << motionType << " in dictionary "
            << dict.name() << nl << "Valid motions are " << valid
            << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// ************************************************************************* //
