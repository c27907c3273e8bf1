// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionaryCheck.H"
#include "openfoamVersion.H"
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
    const word lawType(readName(dict, "type"));

    const auto* constructor = findIn(*dictionaryConstructorTablePtr_, lawType);
    if (!constructor)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown entry 'type' " << lawType << " in dictionary "
            << dict.name() << nl << "Valid spring laws are "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }
    return (*constructor)(dict, youngsModulus);
}


// ************************************************************************* //
