// SPDX-License-Identifier: GPL-3.0-or-later

#include "fsiObjectsModel.H"
#include "fsiObjectsConstraint.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "fvMatrices.H"
#include "stockSolver.H"

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
    velocityName_(stockField<volVectorField>(mesh, dict, "U")),
    pressureName_(stockField<volScalarField>(mesh, dict, "p")),
    objects_(withoutObjects(mesh, dict), stockViscosity(mesh)),
    forcedIndex_(mesh.time().timeIndex())
{
    checkKeys(dict, {"type", "U", "p", "libs"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fsi::fsiObjectsModel::addSupFields() const
{
    return wordList(1, velocityName_);
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
    const label timeIndex = mesh().time().timeIndex();
    if (forcedIndex_ < timeIndex - 1)
    {
        FatalErrorInFunction
            << "No constraint has forced the momentum equation: the model "
            << name() << " of type fsiObjects needs a constraint of type "
            << "fsiObjects in system/fvConstraints" << nl
            << "    objects { type fsiObjects; }" << exit(FatalError);
    }
    objects_.advance
    (
        mesh().lookupObjectRef<volVectorField>(velocityName_),
        mesh().lookupObjectRef<volScalarField>(pressureName_)
    );
}


void Foam::fsi::fsiObjectsModel::force(fvMatrix<vector>& equation)
{
    forcedIndex_ = mesh().time().timeIndex();
    objects_.force(equation);
}


Foam::scalar Foam::fsi::fsiObjectsModel::maxDeltaT() const
{
    const scalar courantNo = objects_.objects().courantNo();
    const scalar maxCo = readPositive
    (
        mesh().time().controlDict(), "maxCo", 0.5
    );
    return
        courantNo > 0
      ? maxCo*mesh().time().deltaTValue()/courantNo
      : fvModel::maxDeltaT();
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
