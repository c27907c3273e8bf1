// SPDX-License-Identifier: GPL-3.0-or-later

#include "swimmingLoad.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(swimmingLoad, 0);

    namespace fsi
    {
        addToRunTimeSelectionTable(objectLoad, swimmingLoad, dictionary);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::swimmingLoad::swimmingLoad(const dictionary& dict)
:
    thrust_(fsi::readPositive(dict, "thrust"))
{
    fsi::checkKeys(dict, {"type", "thrust"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::swimmingLoad::add
(
    const state& object,
    const Time&,
    load& sum
) const
{
    sum.force.x() += object.id % 2 == 0 ? thrust_ : -thrust_;
}


// ************************************************************************* //
