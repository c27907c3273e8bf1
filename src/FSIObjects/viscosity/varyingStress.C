// SPDX-License-Identifier: GPL-3.0-or-later

#include "varyingStress.H"
#include "openfoamVersion.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::varyingStress::addTransposedAtPatches
(
    const volVectorField& gradient,
    const direction d,
    fvVectorMatrix& UEqn
) const
{
    const cartesianMesh& grid = geometry_.grid();
    const vectorField& area = more_.mesh().faceAreas();
    const boolList& inFluid = geometry_.fluidCell();
    vectorField& source = UEqn.source();
    forAll(more_.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pm = more_.boundaryField()[patchi];
        const fvPatchVectorField& pg = gradient.boundaryField()[patchi];
        const vectorField outside
        (
            pg.coupled()
          ? 0.5*(pg.patchInternalField() + pg.patchNeighbourField())
          : tmp<vectorField>(pg)
        );
        const scalarField& open =
            geometry_.fluidFace().boundaryField()[patchi];
        const label start = pm.patch().start();
        forAll(pm, i)
        {
            const label celli = pm.patch().faceCells()[i];
            if (grid.faceDirection(start + i) == d && inFluid[celli])
            {
                source[celli] +=
                    area[start + i][d]*(pm[i] - constant(celli)*open[i])
                   *outside[i];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::varyingStress::varyingStress(const interfaceGeometry& geometry)
:
    geometry_(geometry),
    more_
    (
        IOobject
        (
            "moreViscosityAtFaces",
            nameOf(geometry.grid().mesh().time()),
            geometry.grid().mesh()
        ),
        geometry.grid().mesh(),
        dimensionedScalar(dimVelocity*dimLength, Zero)
    ),
    least_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::varyingStress::set
(
    const volScalarField& more,
    const scalar least
)
{
    least_ = least;
    const surfaceScalarField& fluidFace = geometry_.fluidFace();
    const labelUList& own = more.mesh().owner();
    const labelUList& nei = more.mesh().neighbour();
    forAll(more_, facei)
    {
        more_[facei] =
            fluidFace[facei]*0.5*(more[own[facei]] + more[nei[facei]]);
    }
    forAll(more.boundaryField(), patchi)
    {
        const fvPatchScalarField& pm = more.boundaryField()[patchi];
        more_.boundaryFieldRef()[patchi] ==
            fluidFace.boundaryField()[patchi]
           *(
                pm.coupled()
              ? 0.5*(pm.patchInternalField() + pm.patchNeighbourField())
              : tmp<scalarField>(pm)
            );
    }
}


void Foam::fsi::varyingStress::set
(
    const volScalarField& more,
    const scalarField& moreAtLinks
)
{
    set(more, scalar(0));
    moreAtLinks_ = moreAtLinks;
    ofCells_ = more;
}


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
        const scalar g = perLength*more_[facei];
        if (g != 0)
        {
            upper[facei] -= g;
            lower[facei] -= g;
            diagonal[own[facei]] += g;
            diagonal[nei[facei]] += g;
        }
    }
    forAll(more_.boundaryField(), patchi)
    {
        const fvsPatchScalarField& pm = more_.boundaryField()[patchi];
        addPatchDiffusion(patchi, pm*pm.patch().magSf(), UEqn);
    }
}


void Foam::fsi::varyingStress::addTransposed
(
    const volVectorField& gradient,
    const direction d,
    fvVectorMatrix& UEqn
) const
{
    const cartesianMesh& grid = geometry_.grid();
    const fvMesh& mesh = more_.mesh();
    const boolList& inFluid = geometry_.fluidCell();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    vectorField& source = UEqn.source();
    const vectorField& area = mesh.faceAreas();
    forAll(more_, facei)
    {
        const label a = own[facei], b = nei[facei];
        if (grid.faceDirection(facei) != d || !inFluid[a] || !inFluid[b])
        {
            continue;
        }
        const scalar ofA = more_[facei] - constant(a);
        const scalar ofB = more_[facei] - constant(b);
        if (ofA != 0 || ofB != 0)
        {
            const vector sum(gradient[a] + gradient[b]);
            source[a] += 0.5*area[facei][d]*ofA*sum;
            source[b] -= 0.5*area[facei][d]*ofB*sum;
        }
    }
    addTransposedAtPatches(gradient, d, UEqn);
    forAll(moreAtLinks_, i)
    {
        const wallLink& link = geometry_.wallLinks()[i];
        if (link.dir == d)
        {
            source[link.cell] +=
                (link.upwards ? 1 : -1)*grid.faceArea()
               *(moreAtLinks_[i] - constant(link.cell))*gradient[link.cell];
        }
    }
}


// ************************************************************************* //
