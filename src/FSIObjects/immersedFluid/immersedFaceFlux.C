// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFlux.H"
#include "atFace.H"
#include "openLaplacian.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::fadingPart Foam::fsi::immersedFlux::fadingGradient
(
    const volVectorField& U,
    const cellViscosity& viscosity,
    const scalar eigenvalue
) const
{
    const scalar h = geometry_.grid().spacing();
    const scalar deltaT = rule_.length().tau;
    fadingPart part(geometry_.grid().faceArea()*deltaT);
    if (rule_.secondOrder())
    {
        part.set(U.mesh(), fadingInStep(U, viscosity));
    }
    else if (viscosity.cells)
    {
        part.set(U.mesh(), deltaT*eigenvalue/sqr(h)*(*viscosity.cells));
    }
    else
    {
        part.set(deltaT*viscosity.least*eigenvalue/sqr(h));
    }
    return part;
}


inline Foam::scalar Foam::fsi::immersedFlux::excess
(
    const vectorField& gradient,
    const scalarField& p,
    const labelUList& own,
    const labelUList& nei,
    const label facei
) const
{
    const boolList& fluid = geometry_.fluidCell();
    const label o = own[facei];
    const label n = nei[facei];
    const scalar g =
        fluid[o] == fluid[n]
      ? faces_.mean(gradient, own, nei, facei)
      : faces_.along(gradient[fluid[o] ? o : n], facei);
    return g - (p[n] - p[o])/geometry_.grid().spacing();
}


void Foam::fsi::immersedFlux::fadeOnPatches
(
    const fadingPart& lost,
    const volVectorField& gradient,
    const volScalarField& p,
    surfaceScalarField& flux
) const
{
    const surfaceScalarField& open = geometry_.openArea();
    const boolList& fluid = geometry_.fluidCell();
    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        const bool coupled = pp.coupled();
        if (!coupled && !pp.fixesValue())
        {
            continue;
        }
        const tmp<scalarField> tdpdn(normalGradient(pp));
        const scalarField& dpdn = tdpdn();
        const scalarField mean(faces_.patchMean(gradient, patchi));
        const fvPatchVectorField& pg = gradient.boundaryField()[patchi];
        const vectorField across
        (
            coupled ? pg.patchNeighbourField() : pg.patchInternalField()
        );
        const labelUList& cells = pp.patch().faceCells();
        const label start = pp.patch().start();
        forAll(pp, i)
        {
            const bool here = fluid[cells[i]];
            const bool there =
                coupled
              ? geometry_.fluidAcross()[start + i - flux.size()]
              : here;
            const scalar g =
                here == there
              ? mean[i]
              : faces_.along(here ? gradient[cells[i]] : across[i], start + i);
            flux.boundaryFieldRef()[patchi][i] -=
                lost.onPatch(pp.patch(), i)*open.boundaryField()[patchi][i]
               *(g - dpdn[i]);
        }
    }
}


Foam::scalarList Foam::fsi::immersedFlux::filmVelocities
(
    const surfaceScalarField& velocity
) const
{
    const UList<filmFace>& films = geometry_.films().faces();
    scalarList result(films.size());
    forAll(films, i)
    {
        result[i] = atFace(velocity, films[i].face);
    }
    return result;
}


void Foam::fsi::immersedFlux::setFilmFluxes
(
    const scalarList& velocity,
    const surfaceScalarField& history,
    const scalar viscosity,
    surfaceScalarField& flux
) const
{
    const UList<filmFace>& films = geometry_.films().faces();
    const scalar area = geometry_.grid().faceArea();
    const scalar tau = rule_.length().tau;
    forAll(films, i)
    {
        const label facei = films[i].face;
        const scalar kept = geometry_.films().kept(facei, tau, viscosity);
        const scalar pushed =
            geometry_.grid().faceAlong(facei)
          ? films[i].pushed
          : -films[i].pushed;
        atFace(flux, facei) =
            area*geometry_.openness()[facei]
           *(
                velocity[i] + (1 - kept)*pushed
              + kept*(atFace(history, facei) + tau*forces_[i])
            );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::fsi::immersedFlux::faceFlux
(
    const volVectorField& U,
    const volVectorField& gradient,
    const volScalarField& p,
    const vectorField& wallVelocity,
    const cellViscosity& viscosity,
    const scalar eigenvalue
) const
{
    const scalar deltaT = rule_.length().tau;
    tmp<surfaceScalarField> tflux
    (
        faces_.velocity({U, wallVelocity, &gradient, deltaT})
    );
    surfaceScalarField& flux = tflux.ref();
    flux.rename("phiHbyA");
    flux.dimensions().reset(dimVelocity*dimArea);

    const scalarList inFilms(filmVelocities(flux));
    const tmp<surfaceScalarField> thistory(rule_.start(faceHistory_));
    const surfaceScalarField& history = thistory();
    const surfaceScalarField& open = geometry_.openArea();
    const scalar area = geometry_.grid().faceArea();
    const fadingPart lost(fadingGradient(U, viscosity, eigenvalue));
    const labelUList& own = p.mesh().owner();
    const labelUList& nei = p.mesh().neighbour();
    forAll(flux, facei)
    {
        flux[facei] =
            (flux[facei] + history[facei])*area*open[facei]
          - lost.inside(facei)*open[facei]
           *excess(gradient, p, own, nei, facei);
    }
    forAll(flux.boundaryField(), patchi)
    {
        fvsPatchScalarField& pf = flux.boundaryFieldRef()[patchi];
        pf =
            (pf + history.boundaryField()[patchi])
           *pf.patch().magSf()*open.boundaryField()[patchi];
    }
    fadeOnPatches(lost, gradient, p, flux);
    setFilmFluxes(inFilms, history, viscosity.least, flux);
    return tflux;
}


// ************************************************************************* //
