// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "openLaplacian.H"
#include "swapCoupledCells.H"
#include "extrapolatedCalculatedFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedFluid::addCoupledGradients
(
    volVectorField& gradient,
    List<direction>& count
) const
{
    const boolList& fluid = geometry_.fluidCell();
    const fvMesh& mesh = gradient.mesh();
    boolList fluidAcross;
    swapCoupledCells(mesh, fluid, fluidAcross);
    forAll(gradient.boundaryField(), patchi)
    {
        const fvPatchVectorField& pg = gradient.boundaryField()[patchi];
        if (pg.coupled())
        {
            const label first = pg.patch().start() - mesh.nInternalFaces();
            const vectorField g(pg.patchNeighbourField());
            const labelUList& cells = pg.patch().faceCells();
            forAll(cells, i)
            {
                if (fluidAcross[first + i] && !fluid[cells[i]])
                {
                    gradient[cells[i]] += g[i];
                    ++count[cells[i]];
                }
            }
        }
    }
}


void Foam::fsi::immersedFluid::extendGradient(volVectorField& gradient) const
{
    const fvMesh& mesh = gradient.mesh();
    const boolList& fluid = geometry_.fluidCell();

    // Mean over the fluid neighbours of each solid cell that has any
    forAll(fluid, celli)
    {
        if (!fluid[celli])
        {
            gradient[celli] = Zero;
        }
    }
    List<direction> count(mesh.nCells(), direction(0));
    for (const wallLink& link : geometry_.wallLinks())
    {
        if (link.face < mesh.nInternalFaces())
        {
            const label own = mesh.faceOwner()[link.face];
            const label solid =
                own == link.cell ? mesh.faceNeighbour()[link.face] : own;
            gradient[solid] += gradient[link.cell];
            ++count[solid];
        }
    }
    addCoupledGradients(gradient, count);
    forAll(count, celli)
    {
        if (count[celli] > 1)
        {
            gradient[celli] /= scalar(count[celli]);
        }
    }
    gradient.correctBoundaryConditions();
}


void Foam::fsi::immersedFluid::gradientWeights::divide
(
    vectorField& gradient,
    const label nDims
) const
{
    forAll(gradient, celli)
    {
        if (!isCut[celli])
        {
            gradient[celli] *= 0.5;
            continue;
        }
        for (direction d = 0; d < nDims; ++d)
        {
            gradient[celli][d] /= max(sum[celli][d], SMALL);
        }
    }
}


void Foam::fsi::immersedFluid::sumFaceGradients
(
    const volScalarField& p,
    vectorField& sum,
    gradientWeights& weights
) const
{
    const fvMesh& mesh = p.mesh();
    const cartesianMesh& grid = geometry_.grid();
    const surfaceScalarField& open = geometry_.openArea();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    const scalar perSpacing = 1/grid.spacing();
    forAll(own, facei)
    {
        const direction d = grid.faceDirection(facei);
        const scalar w = open[facei];
        const scalar forwards = grid.faceAlong(facei) ? w : -w;
        const scalar g = forwards*(p[nei[facei]] - p[own[facei]])*perSpacing;
        sum[own[facei]][d] += g;
        sum[nei[facei]][d] += g;
        if (w < 1)
        {
            weights.subtract(own[facei], d, 1 - w);
            weights.subtract(nei[facei], d, 1 - w);
        }
    }
}


void Foam::fsi::immersedFluid::sumPatchGradients
(
    const volScalarField& p,
    vectorField& sum,
    gradientWeights& weights
) const
{
    const cartesianMesh& grid = geometry_.grid();
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
          : tmp<scalarField>::New(pp.size(), Zero)
        );
        forAll(pp, i)
        {
            const direction d = grid.faceDirection(pp.patch().start() + i);
            const scalar w = counts ? open[i] : 0;
            const scalar outwards = pp.patch().Sf()[i][d] > 0 ? w : -w;
            sum[cells[i]][d] += outwards*gradients[i];
            weights.subtract(cells[i], d, 1 - w);
        }
    }
}


Foam::scalarField Foam::fsi::immersedFluid::wallFriction
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField> Foam::fsi::immersedFluid::openGradient
(
    const volScalarField& p
) const
{
    const fvMesh& mesh = p.mesh();

    auto tgradient = tmp<volVectorField>::New
    (
        IOobject("grad(p)", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(p.dimensions()/dimLength, Zero),
        extrapolatedCalculatedFvPatchVectorField::typeName
    );
    volVectorField& gradient = tgradient.ref();
    vectorField& sum = gradient.primitiveFieldRef();
    gradientWeights weights(mesh.nCells());
    sumFaceGradients(p, sum, weights);
    sumPatchGradients(p, sum, weights);
    weights.divide(sum, geometry_.grid().nDims());
    gradient.correctBoundaryConditions();

    return tgradient;
}


Foam::tmp<Foam::volVectorField> Foam::fsi::immersedFluid::gradient
(
    const volScalarField& p
) const
{
    tmp<volVectorField> tgradient(openGradient(p));
    extendGradient(tgradient.ref());
    return tgradient;
}


void Foam::fsi::immersedFluid::correctVelocity
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
