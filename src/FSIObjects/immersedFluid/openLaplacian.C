// SPDX-License-Identifier: GPL-3.0-or-later

#include "openfoamMesh.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A rAU times the area of the faces of a patch
static scalarField patchConductance
(
    const interfaceGeometry& geometry,
    const volScalarField& p,
    const label patchi,
    const scalar rAU,
    const scalar viscosity
)
{
    const fvPatch& patch = p.boundaryField()[patchi].patch();
    scalarField g
    (
        rAU*geometry.openArea().boundaryField()[patchi]*patch.magSf()
    );
    for (label i = 0; i < g.size() && patch.coupled(); ++i)
    {
        g[i] *= geometry.films().kept(patch.start() + i, rAU, viscosity);
    }
    return g;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::fvScalarMatrix> Foam::fsi::openLaplacian
(
    const interfaceGeometry& geometry,
    const volScalarField& p,
    const scalar rAU,
    const scalar viscosity
)
{
    const fvMesh& mesh = p.mesh();
    const surfaceScalarField& open = geometry.openArea();
    const scalar whole =
        rAU*geometry.grid().faceArea()/geometry.grid().spacing();

    auto tequation = newTmp<fvScalarMatrix>
    (
        p,
        dimVolume*p.dimensions()*dimTime/dimArea
    );
    fvScalarMatrix& equation = tequation.ref();
    scalarField& diagonal = equation.diag();
    scalarField& upper = equation.upper();
    diagonal = Zero;
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(upper, facei)
    {
        const scalar g = whole*open[facei];
        upper[facei] = -g;
        diagonal[own[facei]] += g;
        diagonal[nei[facei]] += g;
    }
    for (const filmFace& film : geometry.films().faces())
    {
        if (film.face < mesh.nInternalFaces())
        {
            const scalar kept =
                geometry.films().kept(film.face, rAU, viscosity);
            const scalar lost = (1 - kept)*whole*open[film.face];
            upper[film.face] += lost;
            diagonal[own[film.face]] -= lost;
            diagonal[nei[film.face]] -= lost;
        }
    }
    forAll(p.boundaryField(), patchi)
    {
        addPatchDiffusion
        (
            patchi,
            patchConductance(geometry, p, patchi, rAU, viscosity),
            equation
        );
    }
    return tequation;
}


Foam::tmp<Foam::scalarField> Foam::fsi::normalGradient
(
    const fvPatchScalarField& p
)
{
    return p.coupled() ? p.snGrad(p.patch().deltaCoeffs()) : p.snGrad();
}


void Foam::fsi::addPatchParts
(
    const boolList& active,
    const volScalarField& p,
    fvMatrix<scalar>& pEqn,
    scalarField& b
)
{
    scalarField& diagonal = pEqn.diag();
    forAll(b, celli)
    {
        if (!active[celli])
        {
            b[celli] = 0;
            diagonal[celli] = 0;
        }
    }
    forAll(p.boundaryField(), patchi)
    {
        const labelUList& cells = pEqn.lduAddr().patchAddr(patchi);
        const bool coupled = p.boundaryField()[patchi].coupled();
        for (label i = 0; i < cells.size(); ++i)
        {
            if (active[cells[i]])
            {
                diagonal[cells[i]] += internalCoeffsOf(pEqn)[patchi][i];
                b[cells[i]] +=
                    coupled ? 0 : boundaryCoeffsOf(pEqn)[patchi][i];
            }
        }
    }
}


void Foam::fsi::subtractOutflow
(
    const surfaceScalarField& flux,
    scalarField& source
)
{
    const labelUList& own = flux.mesh().owner();
    const labelUList& nei = flux.mesh().neighbour();
    forAll(own, facei)
    {
        source[own[facei]] -= flux[facei];
        source[nei[facei]] += flux[facei];
    }
    for (const fvsPatchScalarField& pf : flux.boundaryField())
    {
        const labelUList& cells = pf.patch().faceCells();
        forAll(pf, i)
        {
            source[cells[i]] -= pf[i];
        }
    }
}


void Foam::fsi::subtractGradient
(
    const interfaceGeometry& geometry,
    const volScalarField& p,
    const scalar rAU,
    const scalar viscosity,
    surfaceScalarField& flux
)
{
    const surfaceScalarField& open = geometry.openArea();
    const scalar whole =
        rAU*geometry.grid().faceArea()/geometry.grid().spacing();
    const labelUList& own = p.mesh().owner();
    const labelUList& nei = p.mesh().neighbour();
    forAll(own, facei)
    {
        flux[facei] -= whole*open[facei]*(p[nei[facei]] - p[own[facei]]);
    }
    for (const filmFace& film : geometry.films().faces())
    {
        const label facei = film.face;
        if (facei < own.size())
        {
            const scalar kept = geometry.films().kept(facei, rAU, viscosity);
            flux[facei] +=
                (1 - kept)*whole*open[facei]
               *(p[nei[facei]] - p[own[facei]]);
        }
    }
    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        flux.boundaryFieldRef()[patchi] -=
            patchConductance(geometry, p, patchi, rAU, viscosity)
           *normalGradient(pp);
    }
}


// ************************************************************************* //
