// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedGradient.H"
#include "fetchAhead.H"
#include "gradientSums.H"
#include "openfoamVersion.H"
#include "openLaplacian.H"
#include "swapCoupledCells.H"
#include "extrapolatedCalculatedFvPatchFields.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::gradientWeights::divide
(
    vectorField& gradient,
    const label nDims
) const
{
    forAll(cells, i)
    {
        fetchAhead(gradient[fetchedAhead(cells, i)]);
        for (direction d = 0; d < nDims; ++d)
        {
            gradient[cells[i]][d] /= max(sum[i][d], 0.5*SMALL);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedGradient::addCoupledGradients(solidMeans& means) const
{
    const boolList& fluid = geometry_.fluidCell();
    const fvMesh& mesh = means.gradient.mesh();
    boolList fluidAcross;
    swapCoupledCells(mesh, fluid, fluidAcross);
    forAll(means.gradient.boundaryField(), patchi)
    {
        const fvPatchVectorField& pg = means.gradient.boundaryField()[patchi];
        if (pg.coupled())
        {
            const label first = pg.patch().start() - mesh.nInternalFaces();
            const vectorField g(pg.patchNeighbourField());
            const labelUList& cells = pg.patch().faceCells();
            forAll(cells, i)
            {
                if (fluidAcross[first + i] && !fluid[cells[i]])
                {
                    means.add(cells[i], g[i]);
                }
            }
        }
    }
}


void Foam::fsi::immersedGradient::extendGradient(volVectorField& gradient) const
{
    const boolList& fluid = geometry_.fluidCell();
    const boolList& active = geometry_.activeCell();
    const UList<wallLink>& links = geometry_.wallLinks();

    // Inactive cells have no gradient
    forAll(fluid, celli)
    {
        if (active[celli] && !fluid[celli])
        {
            gradient[celli] = Zero;
        }
    }
    solidMeans means(gradient);
    forAll(links, i)
    {
        const wallLink& later = fetchedAhead(links, i);
        fetchAhead(gradient[later.cell]);
        fetchAhead(gradient[max(later.across, 0)]);
        if (links[i].across >= 0)
        {
            means.add(links[i].across, gradient[links[i].cell]);
        }
    }
    addCoupledGradients(means);
    for (const label celli : means.cells)
    {
        if (means.count[celli] > 1)
        {
            gradient[celli] /= scalar(means.count[celli]);
        }
    }
    gradient.correctBoundaryConditions();
}


void Foam::fsi::immersedGradient::sumFaceGradients
(
    const volScalarField& p,
    vectorField& sum
) const
{
    const fvMesh& mesh = p.mesh();
    const cartesianMesh& grid = geometry_.grid();
    const surfaceScalarField& open = geometry_.openArea();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    const scalar half = 0.5/grid.spacing();
    forAll(own, facei)
    {
        const direction d = grid.faceDirection(facei);
        const scalar w = open[facei];
        const scalar forwards = grid.faceAlong(facei) ? w : -w;
        const scalar g = forwards*(p[nei[facei]] - p[own[facei]])*half;
        sum[own[facei]][d] += g;
        sum[nei[facei]][d] += g;
    }
}


void Foam::fsi::immersedGradient::subtractWalls(gradientWeights& weights) const
{
    const scalarField& open = geometry_.openness();
    const UList<wallFace>& walls = geometry_.wallFaces();
    const label nInternal = geometry_.grid().mesh().nInternalFaces();
    forAll(walls, i)
    {
        fetchAhead(open[fetchedAhead(walls, i).face]);
        const wallFace& w = walls[i];
        for (const label celli : {w.lower, w.upper})
        {
            if (celli >= 0 && w.face < nInternal)
            {
                weights.subtract
                (
                    celli,
                    w.dir,
                    w.film
                  ? w.area/geometry_.grid().faceArea()
                  : 1 - open[w.face]
                );
            }
        }
    }
}


void Foam::fsi::immersedGradient::sumPatchGradients
(
    const volScalarField& p,
    vectorField& sum,
    gradientWeights& weights
) const
{
    const cartesianMesh& grid = geometry_.grid();
    const boolList& active = geometry_.activeCell();
    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        const scalarField& open = geometry_.openArea().boundaryField()[patchi];
        const labelUList& cells = pp.patch().faceCells();
        const bool counts = pp.coupled() || pp.fixesValue();
        const scalarField gradients
        (
            counts
          ? normalGradient(pp)
          : newTmp<scalarField>(pp.size(), Zero)
        );
        forAll(pp, i)
        {
            if (!active[cells[i]])
            {
                continue;
            }
            const direction d = grid.faceDirection(pp.patch().start() + i);
            const scalar w = counts ? open[i] : 0;
            const scalar outwards = pp.patch().Sf()[i][d] > 0 ? w : -w;
            sum[cells[i]][d] += 0.5*(outwards*gradients[i]);
            weights.subtract(cells[i], d, 1 - w);
        }
    }
}


Foam::scalarField Foam::fsi::immersedGradient::wallFriction
(
    const scalar viscosity
) const
{
    const scalarField& volume = geometry_.grid().mesh().V();
    scalarField friction(volume.size(), Zero);
    for (const wallLink& link : geometry_.wallLinks())
    {
        friction[link.cell] += viscosity*link.conductance/volume[link.cell];
    }
    return friction;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedGradient::immersedGradient
(
    const interfaceGeometry& geometry
)
:
    geometry_(geometry)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField> Foam::fsi::immersedGradient::openGradient
(
    const volScalarField& p
) const
{
    const fvMesh& mesh = p.mesh();

    auto tgradient = newTmp<volVectorField>
    (
        IOobject("grad(p)", nameOf(mesh.time()), mesh),
        mesh,
        dimensionedVector(p.dimensions()/dimLength, Zero),
        extrapolatedCalculatedFvPatchVectorField::typeName
    );
    volVectorField& gradient = tgradient.ref();
    vectorField& sum = gradient.primitiveFieldRef();
    gradientWeights weights(mesh.nCells());
    sumFaceGradients(p, sum);
    subtractWalls(weights);
    sumPatchGradients(p, sum, weights);
    weights.divide(sum, geometry_.grid().nDims());
    gradient.correctBoundaryConditions();

    return tgradient;
}


Foam::tmp<Foam::volVectorField> Foam::fsi::immersedGradient::gradient
(
    const volScalarField& p
) const
{
    tmp<volVectorField> tgradient(openGradient(p));
    extendGradient(tgradient.ref());
    return tgradient;
}


void Foam::fsi::immersedGradient::correctVelocity
(
    volVectorField& U,
    const volVectorField& lastGradient,
    const volScalarField& p,
    const scalar rAU,
    const scalar viscosity
) const
{
    const tmp<volVectorField> tgradient(gradient(p));
    const vectorField& g = tgradient().primitiveField();
    const scalarField friction(wallFriction(viscosity));
    vectorField& u = U.primitiveFieldRef();
    forAll(u, celli)
    {
        const scalar step = rAU/(1 + rAU*friction[celli]);
        u[celli] += step*(lastGradient[celli] - g[celli]);
    }
    U.correctBoundaryConditions();
}


// ************************************************************************* //
