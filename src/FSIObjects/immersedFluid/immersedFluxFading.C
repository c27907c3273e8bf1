// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFlux.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::fadingPart Foam::fsi::immersedFlux::fadingGradient
(
    const volVectorField& U,
    const scalar viscosity
) const
{
    const scalar h = geometry_.grid().spacing();
    const scalar deltaT = rule_.step();
    fadingPart part(geometry_.grid().faceArea()*deltaT);
    if (rule_.secondOrder())
    {
        part.set(U.mesh(), fadingInStep(U, viscosity));
    }
    else
    {
        part.set(deltaT*viscosity*4/sqr(h));
    }
    return part;
}


void Foam::fsi::immersedFlux::fade
(
    const fadingPart& lost,
    const volVectorField& gradient,
    const volScalarField& p,
    surfaceScalarField& flux
) const
{
    const scalar h = geometry_.grid().spacing();
    const surfaceScalarField& open = geometry_.openArea();
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    const boolList& fluid = geometry_.fluidCell();
    const labelUList& own = p.mesh().owner();
    const labelUList& nei = p.mesh().neighbour();
    const scalar ofCut = rule_.secondOrder() ? 0 : 1;
    forAll(flux, facei)
    {
        const label o = own[facei];
        const label n = nei[facei];
        const bool inside = fluidFace[facei] > 0.5;
        const scalar g =
            inside || fluid[o] == fluid[n]
          ? faces_.mean(gradient, own, nei, facei)
          : faces_.along(gradient[fluid[o] ? o : n], facei);
        flux[facei] -=
            lost.inside(facei)*open[facei]*(inside ? 1 : ofCut)
           *(g - (p[n] - p[o])/h);
    }
    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        if (!pp.coupled())
        {
            continue;
        }
        const scalarField dpdn(pp.snGrad(pp.patch().deltaCoeffs()));
        const scalarField mean(faces_.patchMean(gradient, patchi));
        const vectorField across
        (
            gradient.boundaryField()[patchi].patchNeighbourField()
        );
        const labelUList& cells = pp.patch().faceCells();
        const label start = pp.patch().start();
        forAll(pp, i)
        {
            const bool here = geometry_.fluidCell()[cells[i]];
            const bool there =
                geometry_.fluidAcross()[start + i - flux.size()];
            const scalar g =
                here == there
              ? mean[i]
              : faces_.along(here ? gradient[cells[i]] : across[i], start + i);
            flux.boundaryFieldRef()[patchi][i] -=
                lost.onPatch(pp.patch(), i)*open.boundaryField()[patchi][i]
               *(here && there ? 1 : ofCut)*(g - dpdn[i]);
        }
    }
}


// ************************************************************************* //
