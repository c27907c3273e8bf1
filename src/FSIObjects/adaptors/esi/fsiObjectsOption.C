// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjectsOption.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "stockSolver.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    using fv::option;

    defineTypeNameAndDebug(fsiObjectsOption, 0);
    addToRunTimeSelectionTable(option, fsiObjectsOption, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fsiObjectsOption::fsiObjectsOption
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    fv::option(name, modelType, dict, mesh),
    velocityName_(stockField<volVectorField>(mesh, dict, "U")),
    pressureName_(stockField<volScalarField>(mesh, dict, "p")),
    objects_(withoutObjects(mesh, dict), stockViscosity(mesh))
{
    checkKeys(dict, {"type", "active", "U", "p", "libs"});
    fieldNames_ = wordList(1, velocityName_);
    applied_ = List<bool>(1, false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fsiObjectsOption::constrain
(
    fvMatrix<vector>& equation,
    const label
)
{
    objects_.advance
    (
        mesh_.lookupObjectRef<volVectorField>(velocityName_),
        mesh_.lookupObjectRef<volScalarField>(pressureName_)
    );
    if (mag(objects_.driving().value()) > 0)
    {
        equation -= objects_.driving();
    }
    objects_.force(equation);
}


// ************************************************************************* //
