// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallTreatment.H"
#include "dictionaryCheck.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(wallTreatment, 0);
    defineRunTimeSelectionTable(wallTreatment, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::wallTreatment> Foam::fsi::wallTreatment::New
(
    const dictionary& dict
)
{
    const word type(readName(dict, "wall", "openArea"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, dict, "wall", type
    )(dict);
}


// ************************************************************************* //
