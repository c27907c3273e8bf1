// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjectsModel.H"
#include "fsiObjectsConstraint.H"
#include "addToRunTimeSelectionTable.H"
#include "fvConstraints.H"
#include "fvMatrices.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(fsiObjectsModel, 0);
    addToRunTimeSelectionTable(fvModel, fsiObjectsModel, dictionary);

    defineTypeNameAndDebug(fsiObjectsConstraint, 0);
    addToRunTimeSelectionTable(fvConstraint, fsiObjectsConstraint, dictionary);

    //- Fatal: the mesh changed
    static void refuseMesh(const fvMesh& mesh)
    {
        FatalErrorInFunction
            << "The mesh changes at time " << nameOf(mesh.time())
            << ", but fsiObjects is made for a mesh that stays as it is"
            << exit(FatalError);
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::fsiObjectsModel::checkConstraint() const
{
    const PtrListDictionary<fvConstraint>& constraints =
        Foam::fvConstraints::New(mesh());
    forAll(constraints, i)
    {
        if (isA<fsiObjectsConstraint>(constraints[i]))
        {
            return;
        }
    }
    FatalErrorInFunction
        << "The model " << name() << " of type fsiObjects in constant/fvModels"
        << " needs a constraint of the same type in system/fvConstraints" << nl
        << "    " << name() << " { type fsiObjects; }" << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::fsiObjectsModel::fsiObjectsModel
(
    const word& name,
    const word& modelType,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    fvModel(name, modelType, mesh, dict),
    objects_(mesh, dict, {"type", "libs"})
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fsi::fsiObjectsModel::addSupFields() const
{
    return wordList(1, objects_.velocityName());
}


void Foam::fsi::fsiObjectsModel::addSup
(
    const volVectorField&,
    fvMatrix<vector>& equation
) const
{
    if (mag(objects_.driving().value()) > 0)
    {
        equation += objects_.driving();
    }
}


void Foam::fsi::fsiObjectsModel::correct()
{
    checkConstraint();
    objects_.advance();
}


void Foam::fsi::fsiObjectsModel::force(fvMatrix<vector>& equation)
{
    objects_.force(equation);
}


Foam::scalar Foam::fsi::fsiObjectsModel::maxDeltaT() const
{
    return min(objects_.maxDeltaT(), fvModel::maxDeltaT());
}


bool Foam::fsi::fsiObjectsModel::movePoints()
{
    refuseMesh(mesh());
    return true;
}


void Foam::fsi::fsiObjectsModel::topoChange(const polyTopoChangeMap&)
{
    refuseMesh(mesh());
}


void Foam::fsi::fsiObjectsModel::mapMesh(const polyMeshMap&)
{
    refuseMesh(mesh());
}


void Foam::fsi::fsiObjectsModel::distribute(const polyDistributionMap&)
{
    refuseMesh(mesh());
}


// ************************************************************************* //
