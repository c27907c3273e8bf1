// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFlux.H"
#include "atFace.H"
#include "mathematicalConstants.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::fsi::immersedFlux::fadingInStep
(
    const volVectorField& U,
    const cellViscosity& viscosity
) const
{
    const scalar h = geometry_.grid().spacing();
    const scalar deltaT = rule_.length().tau;
    const scalar perViscosity = sqr(constant::mathematical::pi/h);

    scalarField fading(U.size());
    forAll(fading, celli)
    {
        const scalar viscous = viscosity[celli]*perViscosity;
        fading[celli] = deltaT*(viscous + mag(U[celli])/h);
    }
    return fading;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedFlux::immersedFlux
(
    const interfaceGeometry& geometry,
    const faceVelocities& faces,
    const timeRule& rule
)
:
    geometry_(geometry),
    faces_(faces),
    rule_(rule),
    faceHistory_
    (
        IOobject
        (
            "faceHistory",
            nameOf(geometry.grid().mesh().time()),
            geometry.grid().mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        geometry.grid().mesh(),
        dimensionedScalar(dimVelocity, Zero)
    ),
    moved_(geometry, faces),
    forces_(geometry, faces)
{
    // Files of earlier versions do not say so
    setOriented(faceHistory_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::immersedFlux::endMove
(
    const volVectorField& U,
    const vectorField& walls,
    const scalar viscosity
)
{
    const scalar h = geometry_.grid().spacing();
    const scalar deltaT = rule_.length().tau;
    moved_.end
    (
        U,
        walls,
        deltaT*viscosity*sqr(constant::mathematical::pi/h),
        deltaT/h,
        faceHistory_
    );
}


void Foam::fsi::immersedFlux::storeFaceVelocity
(
    const surfaceScalarField& phi,
    const volVectorField& U,
    const vectorField& wallVelocity,
    const cellViscosity& viscosity
)
{
    const tmp<surfaceScalarField> tinterpolated
    (
        faces_.velocity({U, wallVelocity, nullptr, 0})
    );
    const surfaceScalarField& interpolated = tinterpolated();
    const surfaceScalarField& open = geometry_.openArea();
    const scalar area = geometry_.grid().faceArea();
    const meansAtFaces fading(U.mesh(), fadingInStep(U, viscosity));

    forAll(open, facei)
    {
        faceHistory_[facei] =
            open[facei] > 0
          ? (phi[facei]/(open[facei]*area) - interpolated[facei])
           /(1 + fading.inside(facei))
          : 0;
    }
    forAll(open.boundaryField(), patchi)
    {
        const fvsPatchScalarField& po = open.boundaryField()[patchi];
        fvsPatchScalarField& ph = faceHistory_.boundaryFieldRef()[patchi];
        forAll(po, i)
        {
            ph[i] =
                po.coupled() && po[i] > 0
              ? (
                    phi.boundaryField()[patchi][i]/(po[i]*area)
                  - interpolated.boundaryField()[patchi][i]
                )
               /(1 + fading.onPatch(po.patch(), i))
              : 0;
        }
    }
    // Films fade in the next step
    for (const filmFace& film : geometry_.films().faces())
    {
        atFace(faceHistory_, film.face) =
            atFace(phi, film.face)/(geometry_.openness()[film.face]*area)
          - atFace(interpolated, film.face);
    }
}


// ************************************************************************* //
