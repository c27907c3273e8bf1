// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "fvmDiv.H"
#include "fvmSup.H"
#include "fvcDiv.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Flux through a face and the mean velocity of its two cells; false for
//  faces that are neither internal nor on a coupled patch
static bool faceValues
(
    const surfaceScalarField& flux,
    const volVectorField& U,
    const List<vectorField>& across,
    const label facei,
    scalar& out,
    vector& mean
)
{
    const fvMesh& mesh = U.mesh();
    const vector& own = U[mesh.faceOwner()[facei]];
    if (facei < mesh.nInternalFaces())
    {
        out = flux[facei];
        mean = 0.5*(own + U[mesh.faceNeighbour()[facei]]);
        return true;
    }
    const label patchi = mesh.boundaryMesh().whichPatch(facei);
    const label i = facei - mesh.boundaryMesh()[patchi].start();
    if (across[patchi].empty())
    {
        return false;
    }
    out = flux.boundaryField()[patchi][i];
    mean = 0.5*(own + across[patchi][i]);
    return true;
}


//- Values across the coupled patches; empty lists for others
static List<vectorField> valuesAcross(const volVectorField& U)
{
    List<vectorField> across(U.boundaryField().size());
    forAll(across, patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        if (pU.coupled())
        {
            across[patchi] = pU.patchNeighbourField();
        }
    }
    return across;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::fsi::immersedFluid::wholeFlux
(
    const surfaceScalarField& phi,
    const volVectorField& U,
    const vectorField& wallVelocity
) const
{
    const surfaceScalarField& open = geometry_.openArea();
    const tmp<surfaceScalarField> whole
    (
        faceVelocity(U, wallVelocity, nullptr)
    );
    const surfaceScalarField& area = U.mesh().magSf();
    auto tflux = tmp<surfaceScalarField>::New("convectiveFlux", phi);
    surfaceScalarField& flux = tflux.ref();
    forAll(flux, facei)
    {
        if (open[facei] < 1)
        {
            flux[facei] = whole()[facei]*area[facei];
        }
    }
    forAll(flux.boundaryField(), patchi)
    {
        fvsPatchScalarField& pf = flux.boundaryFieldRef()[patchi];
        forAll(pf, i)
        {
            if (pf.coupled() && open.boundaryField()[patchi][i] < 1)
            {
                pf[i] =
                    whole().boundaryField()[patchi][i]
                   *area.boundaryField()[patchi][i];
            }
        }
    }
    return tflux;
}


Foam::tmp<Foam::volVectorField> Foam::fsi::immersedFluid::wallConvection
(
    const surfaceScalarField& flux,
    const volVectorField& U,
    const vectorField& wallVelocity
) const
{
    const fvMesh& mesh = U.mesh();
    const List<vectorField> across(valuesAcross(U));
    auto tsource = tmp<volVectorField>::New
    (
        IOobject("wallConvection", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimAcceleration, Zero)
    );
    volVectorField& source = tsource.ref();
    for (const wallLink& link : geometry_.wallLinks())
    {
        scalar out = 0;
        vector linear(Zero);
        if (faceValues(flux, U, across, link.face, out, linear))
        {
            if (link.cell != mesh.faceOwner()[link.face])
            {
                out = -out;
            }
            const scalar part = min(0.5/link.wallDistance, 1.0);
            const vector& u = U[link.cell];
            const vector onFace
            (
                u + part*(link.place.interpolate(wallVelocity) - u)
            );
            source[link.cell] -= out*(onFace - linear)/mesh.V()[link.cell];
        }
    }
    return tsource;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::fvVectorMatrix> Foam::fsi::immersedFluid::convection
(
    const surfaceScalarField& phi,
    volVectorField& U,
    const vectorField& wallVelocity
) const
{
    if (!wholeFace_)
    {
        return fvm::div(phi, U) - fvm::Sp(fvc::div(phi), U);
    }
    const surfaceScalarField flux(wholeFlux(phi, U, wallVelocity));
    return
        fvm::div(flux, U, "div(phi,U)")
      - fvm::Sp(fvc::div(flux), U)
      - wallConvection(flux, U, wallVelocity);
}


// ************************************************************************* //
