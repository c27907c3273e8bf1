// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjectsOption.H"
#include "fvMatrices.H"
#include "addToRunTimeSelectionTable.H"

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
    objects_(mesh, dict, {"type", "active", "libs"})
{
    fieldNames_ = wordList(1, objects_.velocityName());
    applied_ = List<bool>(1, false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::fsiObjectsOption::constrain
(
    fvMatrix<vector>& equation,
    const label
)
{
    objects_.advance();
    if (mag(objects_.driving().value()) > 0)
    {
        equation -= objects_.driving();
    }
    objects_.force(equation);
}


// ************************************************************************* //
