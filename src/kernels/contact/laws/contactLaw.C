// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactLaw.H"
#include "dictionaryCheck.H"
#include "selection.H"

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
    const word type(readName(dict, "type", "elastic"));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, dict, typeName, type
    )(dict, scales);
}


// ************************************************************************* //
