// SPDX-License-Identifier: GPL-3.0-or-later

#include "drivingForce.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "selection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(drivingForce, 0);
    defineRunTimeSelectionTable(drivingForce, dictionary);
    addToRunTimeSelectionTable(drivingForce, drivingForce, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::drivingForce::drivingForce(const fvMesh&, const dictionary& dict)
{
    if (readName(dict, "type", typeName) == typeName)
    {
        checkKeys(dict, {"type"});
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::drivingForce> Foam::fsi::drivingForce::New
(
    const fvMesh& mesh,
    const dictionary& fsiProperties
)
{
    const dictionary& dict = fsiProperties.subOrEmptyDict("drivingForce");
    const word type(readName(dict, "type", typeName));
    return constructorOf
    (
        *dictionaryConstructorTablePtr_, fsiProperties, "drivingForce", type
    )(mesh, dict);
}


// ************************************************************************* //
