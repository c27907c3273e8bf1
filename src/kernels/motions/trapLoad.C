// SPDX-License-Identifier: GPL-3.0-or-later

#include "trapLoad.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "readFunction.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(trapLoad, 0);
    addToRunTimeSelectionTable(objectLoad, trapLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::trapLoad::trapLoad(const dictionary& dict)
:
    stiffness_(readPositive(dict, "stiffness")),
    place_(readFunction<vector>(dict, "place"))
{
    checkKeys(dict, {"type", "stiffness", "place"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::trapLoad::add
(
    const state& object,
    const Time& time,
    load& sum
) const
{
    sum.force += stiffness_*(place_->value(time.value()) - object.centre);
}


// ************************************************************************* //
