// SPDX-License-Identifier: GPL-3.0-or-later

#include "stockSolver.H"
#include "dimensionedScalar.H"
#include "IOdictionary.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::fvMesh& Foam::fsi::withoutObjects
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    if (mesh.foundObject<volScalarField>("signedDistance"))
    {
        FatalIOErrorInFunction(dict)
            << dict.name() << " of type fsiObjects would move the objects"
            << " twice: it is for solvers that know no objects, not for"
            << " fsiPisoFoam or fsiFluid, and only one may be active"
            << exit(FatalIOError);
    }
    return mesh;
}


Foam::scalar Foam::fsi::stockViscosity(const fvMesh& mesh)
{
    const dictionary& properties =
        mesh.lookupObject<IOdictionary>(viscosityDictName());
    return
        properties.found("nu")
      ? dimensionedScalar("nu", sqr(dimLength)/dimTime, properties).value()
      : 0;
}


// ************************************************************************* //
