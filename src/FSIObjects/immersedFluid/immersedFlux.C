// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFlux.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::fsi::immersedFlux::history>
Foam::fsi::immersedFlux::historyNames
({
    {history::fading, "fading"},
    {history::limited, "limited"},
    {history::full, "full"},
    {history::none, "none"}
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::fsi::immersedFlux::fadingInStep
(
    const volVectorField& U,
    const scalar viscosity
) const
{
    const scalar h = geometry_.grid().spacing();
    const scalar deltaT = rule_.step();
    const scalar viscous = viscosity*sqr(constant::mathematical::pi/h);

    scalarField fading(U.size());
    forAll(fading, celli)
    {
        fading[celli] = deltaT*(viscous + mag(U[celli])/h);
    }
    return fading;
}


Foam::scalar Foam::fsi::immersedFlux::kept
(
    const scalar velocity,
    const scalar interpolated,
    const scalar fading
) const
{
    const scalar difference = velocity - interpolated;
    switch (history_)
    {
        case history::fading: return difference/(1 + fading);
        case history::full:   return difference;
        case history::none:   return 0;
        case history::limited: break;
    }
    return
        difference
       *(1 - min(mag(difference)/(mag(velocity) + VSMALL), 1.0));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedFlux::immersedFlux
(
    const interfaceGeometry& geometry,
    const faceVelocities& faces,
    const timeRule& rule,
    const dictionary& dict
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
    history_
    (
        historyNames
        [
            readChoice(dict, "faceHistory", "fading", historyNames.names())
        ]
    ),
    moved_(geometry, faces)
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
    const scalar deltaT = history_ == history::fading ? rule_.step() : 0;
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
    const scalar viscosity
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

    // The part that a cut face adds does not fade in its step: it hardly may
    // later on, or the result depends on the step by first order
    const scalar ofCut = rule_.secondOrder() ? cutFading : 1;
    const auto fadingOf = [&](const scalar fluidFace, const scalar value)
    {
        return fluidFace < 0.5 ? ofCut*value : value;
    };

    forAll(open, facei)
    {
        faceHistory_[facei] =
            open[facei] > 0
          ? kept
            (
                phi[facei]/(open[facei]*area),
                interpolated[facei],
                fadingOf(geometry_.fluidFace()[facei], fading.inside(facei))
            )
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
              ? kept
                (
                    phi.boundaryField()[patchi][i]/(po[i]*area),
                    interpolated.boundaryField()[patchi][i],
                    fadingOf
                    (
                        geometry_.fluidFace().boundaryField()[patchi][i],
                        fading.onPatch(po.patch(), i)
                    )
                )
              : 0;
        }
    }
}


// ************************************************************************* //
