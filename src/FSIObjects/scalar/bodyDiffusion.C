// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyDiffusion.H"
#include "openArea.H"
#include "openLaplacian.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::vector& Foam::fsi::bodyDiffusion::axisValues::beyond
(
    const fvMesh& mesh,
    const label facei
) const
{
    return
        facei < mesh.nInternalFaces()
      ? cells_[mesh.faceNeighbour()[facei]]
      : across_[facei - mesh.nInternalFaces()];
}


void Foam::fsi::bodyDiffusion::axisValues::swap(const fvMesh& mesh)
{
    swapCoupledCells(mesh, cells_, across_);
}


Foam::scalar Foam::fsi::bodyDiffusion::resistance(const label facei) const
{
    const cartesianMesh& grid = objects_.grid();
    const scalarField& distance = objects_.levelSet().cellDistance();
    const label here = grid.haloIndex()[grid.mesh().faceOwner()[facei]];
    const scalar open = openSegment
    (
        distance[here], distance[here + grid.stepAcross(facei)]
    );
    if (open == 1)
    {
        return 1/diffusivity_;
    }
    const scalarSurfaces::surface* body = surfaces_.permeableAt(facei);
    return body ? open/diffusivity_ + (1 - open)/body->diffusivity : -1;
}


void Foam::fsi::bodyDiffusion::addFace
(
    const label facei,
    const label celli,
    const scalar slope,
    const scalar r,
    vectorField& counts
)
{
    if (r > 0)
    {
        const direction d = objects_.grid().faceDirection(facei);
        slope_[celli][d] += objects_.grid().faceAlong(facei) ? slope : -slope;
        resistance_[celli][d] += r;
        counts[celli][d] += 1;
    }
}


void Foam::fsi::bodyDiffusion::setCells()
{
    const cartesianMesh& grid = objects_.grid();
    const fvMesh& mesh = grid.mesh();
    const scalar perLength = 1/grid.spacing();
    const scalarField& distance = objects_.levelSet().cellDistance();
    vectorField counts(C_.size(), Zero);
    slope_.reset(C_.size());
    resistance_.reset(C_.size());
    normal_.reset(C_.size());
    forAll(mesh.owner(), facei)
    {
        const label a = mesh.owner()[facei], b = mesh.neighbour()[facei];
        const scalar slope = perLength*(C_[b] - C_[a]);
        const scalar r = resistance(facei);
        addFace(facei, a, slope, r, counts);
        addFace(facei, b, slope, r, counts);
    }
    for (const fvPatchScalarField& pC : C_.boundaryField())
    {
        const tmp<scalarField> slope(normalGradient(pC));
        forAll(pC, i)
        {
            const label facei = pC.patch().start() + i;
            addFace
            (
                facei, pC.patch().faceCells()[i], slope()[i],
                resistance(facei), counts
            );
        }
    }
    forAll(counts, celli)
    {
        const label here = grid.haloIndex()[celli];
        for (direction d = 0; d < grid.nDims(); ++d)
        {
            slope_[celli][d] /= max(counts[celli][d], 1);
            resistance_[celli][d] /= max(counts[celli][d], 1);
            const label stride = grid.haloStride(d);
            normal_[celli][d] =
                0.5*perLength
               *(distance[here + stride] - distance[here - stride]);
        }
    }
    slope_.swap(mesh);
    resistance_.swap(mesh);
    normal_.swap(mesh);
}


Foam::scalar Foam::fsi::bodyDiffusion::conductivity
(
    const label facei,
    scalar& byOthers
) const
{
    const cartesianMesh& grid = objects_.grid();
    const fvMesh& mesh = grid.mesh();
    const label celli = mesh.faceOwner()[facei];
    const scalar open = geometry_.openness()[facei];
    const scalar mean =
        open*diffusivity_
      + (1 - open)*surfaces_.permeableAt(facei)->diffusivity;

    // Sums over the axes; only the distance is exact at the face's own one
    const direction dir = grid.faceDirection(facei);
    const scalarField& distance = objects_.levelSet().cellDistance();
    const label here = grid.haloIndex()[celli];
    const label step = grid.stepAcross(facei);
    const scalar r = resistance(facei);
    const scalar n =
        (distance[here + step] - distance[here])/grid.spacing();
    scalar all = sqr(n)*r, others = 0;
    for (direction d = 0; d < grid.nDims(); ++d)
    {
        const scalar ra = resistance_[celli][d];
        const scalar rb = resistance_.beyond(mesh, facei)[d];
        const scalar weight = 1/max(scalar(ra > 0) + scalar(rb > 0), scalar(1));
        if (d != dir)
        {
            const scalar normal =
                0.5*(normal_[celli][d] + normal_.beyond(mesh, facei)[d]);
            all += sqr(normal)*weight*(ra + rb);
            others +=
                normal*weight
               *(slope_[celli][d] + slope_.beyond(mesh, facei)[d]);
        }
    }
    if (all <= VSMALL)
    {
        return mean;
    }
    const scalar part = (mean - 1/r)*n*r/all;
    byOthers = -part*others;
    return mean - part*n;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyDiffusion::set
(
    surfaceScalarField& conductivity,
    scalarField& source
)
{
    setCells();
    const scalar area = geometry_.grid().faceArea();
    const scalar near = geometry_.grid().spacing();
    const scalarField& distance = objects_.levelSet().cellDistance();
    const boolList& fixed = surfaces_.fixed();
    const auto isNear = [&](const label facei)
    {
        return
            surfaces_.permeableAt(facei)
         && distance[surfaces_.innerSample(facei)] < near;
    };
    const fvMesh& mesh = C_.mesh();
    forAll(conductivity, facei)
    {
        const label a = mesh.owner()[facei], b = mesh.neighbour()[facei];
        if (isNear(facei) && !fixed[a] && !fixed[b])
        {
            scalar byOthers = 0;
            conductivity[facei] = area*this->conductivity(facei, byOthers);
            source[a] += area*byOthers;
            source[b] -= area*byOthers;
        }
    }
    for (fvsPatchScalarField& pf : conductivity.boundaryFieldRef())
    {
        const labelUList& cells = pf.patch().faceCells();
        forAll(pf, i)
        {
            const label facei = pf.patch().start() + i;
            if (isNear(facei) && !fixed[cells[i]])
            {
                scalar byOthers = 0;
                pf[i] = area*this->conductivity(facei, byOthers);
                source[cells[i]] += pf.coupled() ? area*byOthers : 0;
            }
        }
    }
}


// ************************************************************************* //
