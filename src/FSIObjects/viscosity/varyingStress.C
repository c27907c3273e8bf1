// SPDX-License-Identifier: GPL-3.0-or-later

#include "varyingStress.H"
#include "openLaplacian.H"
#include "swapCoupledCells.H"
#include "transposedRows.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Gradient of the component d of the velocity
inline static vector column(const tensor& gradient, const direction d)
{
    return vector(gradient[d], gradient[3 + d], gradient[6 + d]);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::varyingStress::addTransposedAtPatch
(
    const label patchi,
    const UList<vector>& gradient,
    vectorField& source
) const
{
    const cartesianMesh& grid = geometry_.grid();
    const vectorField& area = more_.mesh().faceAreas();
    const fvPatch& patch = more_.mesh().boundary()[patchi];
    const scalarField more(atPatch(patchi));
    const scalarField& open = geometry_.fluidFace().boundaryField()[patchi];
    const label start = patch.start();
    forAll(more, i)
    {
        const label celli = patch.faceCells()[i];
        if (geometry_.fluidCell()[celli])
        {
            source[celli] +=
                area[start + i][grid.faceDirection(start + i)]
               *(more[i] - constant(celli)*open[i])*gradient[i];
        }
    }
}


inline Foam::scalar Foam::fsi::varyingStress::atFace
(
    const label facei,
    const label a,
    const label b
) const
{
    return geometry_.fluidFace()[facei]*0.5*(more_[a] + more_[b]);
}


Foam::tmp<Foam::scalarField> Foam::fsi::varyingStress::atPatch
(
    const label patchi
) const
{
    const fvPatchScalarField& pm = more_.boundaryField()[patchi];
    return
        geometry_.fluidFace().boundaryField()[patchi]
       *(
            pm.coupled()
          ? 0.5*(pm.patchInternalField() + pm.patchNeighbourField())
          : tmp<scalarField>(pm)
        );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::varyingStress::addDiffusion(fvVectorMatrix& UEqn) const
{
    const fvMesh& mesh = more_.mesh();
    const scalar perLength =
        geometry_.grid().faceArea()/geometry_.grid().spacing();
    scalarField& diagonal = UEqn.diag();
    scalarField& upper = UEqn.upper();
    scalarField& lower = UEqn.lower();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(upper, facei)
    {
        const label a = own[facei], b = nei[facei];
        const scalar g = perLength*atFace(facei, a, b);
        if (g != 0)
        {
            upper[facei] -= g;
            lower[facei] -= g;
            diagonal[a] += g;
            diagonal[b] += g;
        }
    }
    forAll(more_.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        addPatchDiffusion(patchi, atPatch(patchi)*patch.magSf(), UEqn);
    }
}


void Foam::fsi::varyingStress::addTransposed
(
    const volTensorField& gradient,
    fvVectorMatrix& UEqn
) const
{
    const cartesianMesh& grid = geometry_.grid();
    const fvMesh& mesh = more_.mesh();
    const boolList& inFluid = geometry_.fluidCell();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    vectorField& source = UEqn.source();
    forAll(nei, facei)
    {
        const label a = own[facei], b = nei[facei];
        if (!inFluid[a] || !inFluid[b])
        {
            continue;
        }
        const scalar more = atFace(facei, a, b);
        const scalar ofA = more - constant(a);
        const scalar ofB = more - constant(b);
        if (ofA != 0 || ofB != 0)
        {
            const direction d = grid.faceDirection(facei);
            const scalar half = 0.5*mesh.faceAreas()[facei][d];
            const vector sum(column(gradient[a], d) + column(gradient[b], d));
            source[a] += half*ofA*sum;
            source[b] -= half*ofB*sum;
        }
    }
    forAll(more_.boundaryField(), patchi)
    {
        const fvPatchTensorField& pg = gradient.boundaryField()[patchi];
        const tensorField outside
        (
            pg.coupled()
          ? 0.5*(pg.patchInternalField() + pg.patchNeighbourField())
          : tmp<tensorField>(pg)
        );
        vectorField columns(outside.size());
        forAll(columns, i)
        {
            columns[i] =
                column(outside[i], grid.faceDirection(pg.patch().start() + i));
        }
        addTransposedAtPatch(patchi, columns, source);
    }
    forAll(moreAtLinks_, i)
    {
        const wallLink& link = geometry_.wallLinks()[i];
        source[link.cell] +=
            (link.upwards ? 1 : -1)*grid.faceArea()
           *(moreAtLinks_[i] - constant(link.cell))
           *column(gradient[link.cell], link.dir);
    }
}


void Foam::fsi::varyingStress::addTransposed
(
    fvVectorMatrix& UEqn
) const
{
    const cartesianMesh& grid = geometry_.grid();
    const volVectorField& U = UEqn.psi();
    const label nInternal = grid.mesh().nInternalFaces();
    vectorField& source = UEqn.source();
    const transposedRows rows(grid, U, more_, least_, geometry_.fluidCell());
    rows.add(source);

    // Gradients on this side of the patches, and across
    vectorField mine(grid.mesh().nFaces() - nInternal, Zero), across;
    for (const fvPatchVectorField& pU : U.boundaryField())
    {
        forAll(pU, i)
        {
            const label facei = pU.patch().start() + i;
            const direction d = grid.faceDirection(facei);
            const label celli = pU.patch().faceCells()[i];
            vector& g = mine[facei - nInternal];
            g = rows.gradient(celli, d);
            if (!pU.coupled())
            {
                g[d] =
                    (grid.faceAlong(facei) ? 2 : -2)
                   *(pU[i][d] - U[celli][d])/grid.spacing();
            }
        }
    }
    swapCoupledFaces(grid.mesh(), mine, across);
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        SubList<vector> gradient
        (
            mine, pU.size(), pU.patch().start() - nInternal
        );
        for (label i = 0; i < pU.size() && pU.coupled(); ++i)
        {
            const label facei = pU.patch().start() + i - nInternal;
            gradient[i] = 0.5*(gradient[i] + across[facei]);
        }
        addTransposedAtPatch(patchi, gradient, source);
    }
}


// ************************************************************************* //
