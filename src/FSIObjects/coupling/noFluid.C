// SPDX-License-Identifier: GPL-3.0-or-later

#include "noFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "sharedPrediction.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(noFluid, 0);
    addToRunTimeSelectionTable(couplingModel, noFluid, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::noFluid::noFluid
(
    fsiSystem& system,
    stepTimer& timer,
    const dictionary& dict
)
:
    couplingModel(system, timer, dict)
{
    checkKeys(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::noFluid::begin
(
    const groupNodal& force,
    const volScalarField&
)
{
    const Time& time = system_.grid.mesh().time();

    predictShared
    (
        system_.objects,
        time.value() - system_.deltaT(),
        system_.stepTime(),
        force,
        velocity_.change()
    );
    constrain(velocity_);
    contact(velocity_);
    constrain(velocity_);
}


// ************************************************************************* //
