// SPDX-License-Identifier: GPL-3.0-or-later

#include "hydrodynamicLoad.H"
#include "dictionaryCheck.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(hydrodynamicLoad, 0);
    defineRunTimeSelectionTable(hydrodynamicLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::hydrodynamicLoad> Foam::fsi::hydrodynamicLoad::New
(
    const fluidStep& step,
    const dictionary& dict
)
{
    const word type(readName(dict, "load", "wallForce"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, dict, "load", type
    )(step);
}


// ************************************************************************* //
