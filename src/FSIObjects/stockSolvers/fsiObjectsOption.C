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

    //- Name of a field that an entry gives; fatal if there is no such field
    template<class Field>
    static word fieldName
    (
        const fvMesh& mesh,
        const dictionary& dict,
        const word& key
    )
    {
        const word name(dict.lookupOrDefault<word>(key, key));
        if (!mesh.foundObject<Field>(name))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' in dictionary " << dict.name()
                << " is " << name << " but the fields of this type are "
                << flatOutput(mesh.sortedNames<Field>()) << exit(FatalIOError);
        }
        return name;
    }


    //- The mesh; fatal if its objects belong to the solver or another option
    static const fvMesh& withoutObjects
    (
        const fvMesh& mesh,
        const dictionary& dict
    )
    {
        if (mesh.foundObject<volScalarField>("signedDistance"))
        {
            FatalIOErrorInFunction(dict)
                << "Option " << dict.name() << " of type fsiObjects would"
                << " move the objects twice: it is for solvers that know no"
                << " objects, not for fsiPisoFoam, and only one may be active"
                << exit(FatalIOError);
        }
        return mesh;
    }


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
    velocityName_(fieldName<volVectorField>(mesh, dict, "U")),
    pressureName_(fieldName<volScalarField>(mesh, dict, "p")),
    objects_(withoutObjects(mesh, dict), newtonianViscosity(mesh))
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
