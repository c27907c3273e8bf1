// SPDX-License-Identifier: GPL-3.0-or-later

#include "rotationalPressure.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Cells with fluid alone, none of whose faces a wall closes in part or is a
//  film or gives the pressure
static boolList wholeCells
(
    const interfaceGeometry& geometry,
    const volScalarField& p
)
{
    boolList whole(geometry.fluidCell());
    const surfaceScalarField& open = geometry.openArea();
    const fvMesh& mesh = open.mesh();
    forAll(open, facei)
    {
        if (open[facei] < 1)
        {
            whole[mesh.owner()[facei]] = false;
            whole[mesh.neighbour()[facei]] = false;
        }
    }
    forAll(open.boundaryField(), patchi)
    {
        const fvsPatchScalarField& po = open.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        const labelUList& cells = po.patch().faceCells();
        forAll(po, i)
        {
            if (po.coupled() ? po[i] < 1 : pp.fixesValue())
            {
                whole[cells[i]] = false;
            }
        }
    }
    for (const filmFace& film : geometry.films().faces())
    {
        whole[mesh.faceOwner()[film.face]] = false;
        if (film.face < mesh.nInternalFaces())
        {
            whole[mesh.faceNeighbour()[film.face]] = false;
        }
    }
    return whole;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addRotationalPart
(
    const interfaceGeometry& geometry,
    const scalarField& nu,
    const volScalarField& last,
    const scalar tau,
    volScalarField& p
)
{
    const cartesianMesh& grid = geometry.grid();
    const surfaceScalarField& open = geometry.openArea();
    const labelUList& own = p.mesh().owner();
    const labelUList& nei = p.mesh().neighbour();
    const scalarField change(p.primitiveField() - last.primitiveField());
    scalarField laplacian(p.size(), Zero);
    forAll(nei, facei)
    {
        const label a = own[facei], b = nei[facei];
        const scalar g = open[facei]*(change[b] - change[a]);
        laplacian[a] += g;
        laplacian[b] -= g;
    }
    const scalar h = grid.spacing();
    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        const scalarField g
        (
            h*open.boundaryField()[patchi]
           *(normalGradient(pp) - normalGradient(last.boundaryField()[patchi]))
        );
        const labelUList& cells = pp.patch().faceCells();
        forAll(g, i)
        {
            laplacian[cells[i]] += g[i];
        }
    }

    const scalar perNu = tau/sqr(grid.spacing());
    const boolList whole(wholeCells(geometry, p));
    forAll(p, celli)
    {
        if (whole[celli])
        {
            p[celli] -= perNu*nu[celli]*laplacian[celli];
        }
    }
    p.correctBoundaryConditions();
}


// ************************************************************************* //
