// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallGhosts.H"
#include "surfacePlace.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::wallGhosts::setRows()
{
    // A fluid cell beside the wall is a cell from it at most
    const labelList& haloIndex = geometry_.grid().haloIndex();
    const boolList& fluid = geometry_.fluidCell();
    const scalar least = -(1 - 1e-9)*levelSet_.bandWidth();
    const scalar most = 2.001*geometry_.grid().spacing();
    rowOf_.setSize(fluid.size());
    rowOf_ = -1;
    DynamicList<label> cells;
    DynamicList<scalar> distance;
    forAll(fluid, celli)
    {
        const scalar d = levelSet_.cellDistance()[haloIndex[celli]];
        if (d > least && d < most)
        {
            rowOf_[celli] = cells.size();
            cells.append(celli);
            distance.append(d);
        }
    }
    cells_.transfer(cells);
    distance_.setSize(cells_.size());
    forAll(distance_, row)
    {
        distance_[row] = distance[row];
    }
}


void Foam::fsi::wallGhosts::setNeighbours()
{
    const polyMesh& mesh = geometry_.grid().mesh();
    neighbours_.clear();
    across_.clear();
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    forAll(nei, facei)
    {
        const label a = rowOf_[own[facei]];
        const label b = rowOf_[nei[facei]];
        if (a >= 0 && b >= 0)
        {
            neighbours_.append(labelPair(a, b));
        }
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (label i = 0; i < patch.size() && patch.coupled(); ++i)
        {
            const label row = rowOf_[patch.faceCells()[i]];
            if (row >= 0)
            {
                across_.append
                (
                    labelPair(row, patch.start() + i - mesh.nInternalFaces())
                );
            }
        }
    }
}


template<class Type>
Foam::Field<Type> Foam::fsi::wallGhosts::sumOfNeighbours
(
    const Field<Type>& values
) const
{
    const polyMesh& mesh = geometry_.grid().mesh();
    Field<Type> sums(values.size(), Type(Zero));
    for (const labelPair& pair : neighbours_)
    {
        sums[pair.first()] += values[pair.second()];
        sums[pair.second()] += values[pair.first()];
    }
    List<Type> mine, theirs;
    setZeroOnCoupled(mesh, mine);
    for (const labelPair& pair : across_)
    {
        mine[pair.second()] = values[pair.first()];
    }
    swapCoupledFaces(mesh, mine, theirs);
    for (const labelPair& pair : across_)
    {
        sums[pair.first()] += theirs[pair.second()];
    }
    return sums;
}


void Foam::fsi::wallGhosts::setLayers()
{
    // Are there neighbours inside objects, phi, phi^2
    const label n = cells_.size();
    vectorField known(n, Zero);
    forAll(known, row)
    {
        const scalar d = distance_[row];
        known[row] = inFluid(row) ? vector(0, d, d*d) : vector(1, 0, 0);
    }
    layer_.setSize(n);
    layer_ = -1;
    sum_.setSize(n);
    sum_ = Zero;
    squares_.setSize(n);
    squares_ = Zero;
    vectorField sums(sumOfNeighbours(known));
    for (label layeri = 0; layeri <= nLayers; ++layeri)
    {
        vectorField next(n, Zero);
        forAll(next, row)
        {
            const bool here = layeri == 0
              ? inFluid(row) && sums[row].x() > 0
              : !inFluid(row) && layer_[row] < 0 && sums[row].z() > 0;
            if (here)
            {
                layer_[row] = layeri;
                next[row] = sums[row];
            }
            if (here && layeri == 0)
            {
                next[row] += known[row];
            }
            else if (here)
            {
                sum_[row] = sums[row].y();
                squares_[row] = sums[row].z();
            }
        }
        if (layeri < nLayers)
        {
            sums = sumOfNeighbours(next);
        }
    }
}


void Foam::fsi::wallGhosts::bringBack(vectorField& force) const
{
    vectorField sums(cells_.size(), Zero);
    for (label layeri = nLayers; layeri >= 0; --layeri)
    {
        forAll(sums, row)
        {
            if (layer_[row] != layeri)
            {
                sums[row] = Zero;
            }
            else if (layeri > 0)
            {
                vector& f = force[cells_[row]];
                const vector slope(distance_[row]/squares_[row]*f);
                sums[row] += slope;
                f -= sum_[row]*slope;
            }
        }
        const vectorField last(layeri == 0 ? sums : vectorField());
        sums = sumOfNeighbours(sums);
        if (layeri == 0)
        {
            sums += last;
        }
    }
    forAll(sums, row)
    {
        if (inFluid(row))
        {
            force[cells_[row]] += distance_[row]*sums[row];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallGhosts::update()
{
    setRows();
    setNeighbours();
    setLayers();
}


void Foam::fsi::wallGhosts::extend(volVectorField& U) const
{
    // sum phi_c u_c of the rows of a layer
    vectorField sums(cells_.size(), Zero);
    forAll(sums, row)
    {
        if (inFluid(row))
        {
            sums[row] = distance_[row]*U[cells_[row]];
        }
    }
    const vectorField own(sums);
    for (label layeri = 0; layeri <= nLayers; ++layeri)
    {
        sums = sumOfNeighbours(sums);
        forAll(sums, row)
        {
            if (layer_[row] != layeri)
            {
                sums[row] = Zero;
                continue;
            }
            if (layeri == 0)
            {
                sums[row] += own[row];
                continue;
            }
            vector& u = U[cells_[row]];
            u += distance_[row]/squares_[row]*(sums[row] - sum_[row]*u);
        }
    }
    U.correctBoundaryConditions();
}


void Foam::fsi::wallGhosts::bringBack
(
    const surfaceSet& surfaces,
    vectorField& force,
    vectorField& nodal
) const
{
    bringBack(force);
    const labelList& haloIndex = geometry_.grid().haloIndex();
    const boolList& fluid = geometry_.fluidCell();
    labelList face(1);
    label found;
    forAll(force, celli)
    {
        if (fluid[celli])
        {
            continue;
        }
        face[0] = levelSet_.nearestFace(haloIndex[celli]);
        if (face[0] >= 0 && magSqr(force[celli]) > 0)
        {
            const point& C = geometry_.grid().mesh().C()[celli];
            nearestPlace(surfaces, C, face, found).spread(nodal, force[celli]);
        }
        force[celli] = Zero;
    }
}


// ************************************************************************* //
