// SPDX-License-Identifier: GPL-3.0-or-later

#include "givenDriving.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "readFunction.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(givenDriving, 0);
    addToRunTimeSelectionTable(drivingForce, givenDriving, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::givenDriving::givenDriving
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    drivingForce(mesh, dict),
    function_(readFunction<vector>(dict, "acceleration"))
{
    checkKeys(dict, {"type", "acceleration"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::givenDriving::update
(
    const volVectorField& U,
    const population&,
    const scalar
)
{
    const Time& time = U.time();
    acceleration_ = function_->value(time.value());
    change_ =
        acceleration_ - function_->value(time.value() - time.deltaTValue());
}


// ************************************************************************* //
