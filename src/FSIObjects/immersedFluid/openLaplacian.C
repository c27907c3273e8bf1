// SPDX-License-Identifier: GPL-3.0-or-later

#include "openfoamMesh.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::fvScalarMatrix> Foam::fsi::openLaplacian
(
    const interfaceGeometry& geometry,
    const volScalarField& p,
    const scalar rAU
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
    forAll(p.boundaryField(), patchi)
    {
        const scalarField& area = p.boundaryField()[patchi].patch().magSf();
        addPatchDiffusion
        (
            patchi,
            rAU*open.boundaryField()[patchi]*area,
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
    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        flux.boundaryFieldRef()[patchi] -=
            rAU*open.boundaryField()[patchi]*pp.patch().magSf()
           *normalGradient(pp);
    }
}


// ************************************************************************* //
