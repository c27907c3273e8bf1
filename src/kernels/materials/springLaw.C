// SPDX-License-Identifier: GPL-3.0-or-later

#include "springLaw.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(springLaw, 0);
    defineRunTimeSelectionTable(springLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::springLaw> Foam::fsi::springLaw::New
(
    const dictionary& dict,
    const scalar youngsModulus
)
{
    const word lawType(dict.get<word>("type"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(lawType);
    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown entry 'type' " << lawType << " in dictionary "
            << dict.name() << nl << "Valid spring laws are "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }
    return cstrIter()(dict, youngsModulus);
}


// ************************************************************************* //
