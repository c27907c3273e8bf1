// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "extrapolatedCalculatedFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedFluid::addCoupledGradients
(
    const volVectorField& gradient,
    vectorField& sum,
    scalarField& count
) const
{
    const boolList& fluid = geometry_.fluidCell();

    // A neighbour across a coupled patch is fluid where it has a link, or
    // where the mask says so; the mask of the face is 0 for a solid cell here
    const volScalarField mask(geometry_.fluidMask());
    forAll(mask.boundaryField(), patchi)
    {
        const fvPatchScalarField& pm = mask.boundaryField()[patchi];
        if (pm.coupled())
        {
            const scalarField across(pm.patchNeighbourField());
            const vectorField g
            (
                gradient.boundaryField()[patchi].patchNeighbourField()
            );
            const labelUList& cells = pm.patch().faceCells();
            forAll(cells, i)
            {
                if (across[i] > 0.5 && !fluid[cells[i]])
                {
                    sum[cells[i]] += g[i];
                    count[cells[i]] += 1;
                }
            }
        }
    }
}


void Foam::fsi::immersedFluid::extendGradient(volVectorField& gradient) const
{
    const fvMesh& mesh = gradient.mesh();
    const boolList& fluid = geometry_.fluidCell();

    // Sums over fluid neighbours of each solid cell that has any
    vectorField sum(mesh.nCells(), Zero);
    scalarField count(mesh.nCells(), Zero);
    const auto add = [&](const label celli, const vector& g)
    {
        if (!fluid[celli])
        {
            sum[celli] += g;
            count[celli] += 1;
        }
    };

    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        if (fluid[own[facei]] != fluid[nei[facei]])
        {
            add(own[facei], gradient[nei[facei]]);
            add(nei[facei], gradient[own[facei]]);
        }
    }

    addCoupledGradients(gradient, sum, count);

    forAll(count, celli)
    {
        if (count[celli] > 0)
        {
            gradient[celli] = sum[celli]/count[celli];
        }
        else if (!fluid[celli])
        {
            gradient[celli] = Zero;
        }
    }
    gradient.correctBoundaryConditions();
}


void Foam::fsi::immersedFluid::sumFaceGradients
(
    const volScalarField& p,
    vectorField& sum,
    vectorField& weight
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
        const scalar forwards = mesh.Sf()[facei][d] > 0 ? w : -w;
        const scalar g = forwards*(p[nei[facei]] - p[own[facei]])*perSpacing;
        sum[own[facei]][d] += g;
        sum[nei[facei]][d] += g;
        weight[own[facei]][d] += w;
        weight[nei[facei]][d] += w;
    }
    forAll(p.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        if (pp.coupled() || pp.fixesValue())
        {
            const labelUList& cells = pp.patch().faceCells();
            const scalarField gradients
            (
                pp.coupled()
              ? pp.snGrad(pp.patch().deltaCoeffs())
              : pp.snGrad()
            );
            forAll(cells, i)
            {
                const direction d =
                    grid.faceDirection(pp.patch().start() + i);
                const scalar w = open.boundaryField()[patchi][i];
                sum[cells[i]][d] +=
                    pp.patch().Sf()[i][d] > 0
                  ? w*gradients[i]
                  : -w*gradients[i];
                weight[cells[i]][d] += w;
            }
        }
    }
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
    vectorField weight(mesh.nCells(), Zero);
    sumFaceGradients(p, gradient.primitiveFieldRef(), weight);

    const direction nDims = geometry_.grid().nDims();
    forAll(gradient, celli)
    {
        for (direction d = 0; d < nDims; ++d)
        {
            gradient[celli][d] /= max(weight[celli][d], SMALL);
        }
    }
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
    const scalar rAU
) const
{
    const tmp<volVectorField> tgradient(gradient(p));
    const vectorField& g = tgradient().primitiveField();
    vectorField& u = U.primitiveFieldRef();
    forAll(u, celli)
    {
        u[celli] += rAU*(lastGradient[celli] - g[celli]);
    }
    U.correctBoundaryConditions();
}


// ************************************************************************* //
