// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjectsOption.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    using fv::option;

    defineTypeNameAndDebug(fsiObjectsOption, 0);
    addToRunTimeSelectionTable(option, fsiObjectsOption, dictionary);

    //- Viscosity of the Newtonian fluid [m2/s]; 0 for other fluids (direct
    //  forcing does not need it)
    static scalar newtonianViscosity(const fvMesh& mesh)
    {
        const dictionary& properties =
            mesh.lookupObject<dictionary>("transportProperties");
        return
            dimensionedScalar::lookupOrDefault
            (
                "nu",
                properties,
                dimViscosity,
                0
            ).value();
    }
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
    velocityName_(dict.lookupOrDefault<word>("U", "U")),
    pressureName_(dict.lookupOrDefault<word>("p", "p")),
    objects_(mesh, newtonianViscosity(mesh))
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
    objects_.force
    (
        equation,
        mesh_.lookupObjectRef<volVectorField>(velocityName_),
        mesh_.lookupObjectRef<volScalarField>(pressureName_)
    );
}


// ************************************************************************* //
