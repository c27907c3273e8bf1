// SPDX-License-Identifier: GPL-3.0-or-later

#include "constantDriving.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(constantDriving, 0);
    addToRunTimeSelectionTable(drivingForce, constantDriving, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::constantDriving::constantDriving
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    drivingForce(mesh, dict),
    acceleration_(readFinite(dict, "acceleration"))
{
    checkKeys(dict, {"type", "acceleration"});
}


// ************************************************************************* //
