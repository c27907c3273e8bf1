// SPDX-License-Identifier: GPL-3.0-or-later

#include "noLubrication.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(noLubrication, 0);
    addToRunTimeSelectionTable(lubrication, noLubrication, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::noLubrication::noLubrication
(
    const dictionary& dict,
    const contactScales&
)
{
    checkKeys(dict, {"type"});
}


// ************************************************************************* //
