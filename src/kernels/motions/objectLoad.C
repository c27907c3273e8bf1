// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectLoad.H"
#include "dictionaryCheck.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(objectLoad, 0);
    defineRunTimeSelectionTable(objectLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::PtrList<Foam::fsi::objectLoad> Foam::fsi::objectLoad::newLoads
(
    const dictionary& loads
)
{
    PtrList<objectLoad> result(loads.size());
    label loadi = 0;
    for (const entry& e : loads)
    {
        const dictionary& dict = dictOf(loads, e, "load");
        const word type(getEntry<word>(dict, "type"));
        result.set
        (
            loadi++,
            constructorOf
            (
                *dictionaryConstructorTablePtr_, dict, "load", type
            )(dict)
        );
    }
    return result;
}


// ************************************************************************* //
