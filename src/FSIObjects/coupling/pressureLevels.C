// SPDX-License-Identifier: GPL-3.0-or-later

#include "pressureLevels.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Cells that a rank looks beyond its own
static constexpr label beyond = 16;

//- Distance between the samples of sides that are seeded, in cells
static constexpr label sideStep = 8;


//- Functions of a cell from its nearest objects: weights d^-2, in the order of
//  the objects
static pressureLevels::cellValues valuesOf(nearestObjects::entry nearest)
{
    pressureLevels::cellValues result;
    double sum = 0;
    label n = 0;
    for (; n < pressureLevels::nNearest && nearest.object[n] >= 0; ++n)
    {
        const double d = max(double(nearest.distance[n]), 0.25);
        result.object[n] = nearest.object[n];
        result.value[n] = 1/(d*d);
        sum += result.value[n];
    }
    for (label i = 0; i < n; ++i)
    {
        result.value[i] /= sum;
        for (label k = i; k > 0 && result.object[k] < result.object[k - 1]; --k)
        {
            std::swap(result.object[k], result.object[k - 1]);
            std::swap(result.value[k], result.value[k - 1]);
        }
    }
    return result;
}


//- A difference of positions in a periodic domain
static vector shortest(vector d, const vector& period)
{
    for (direction dir = 0; dir < 3; ++dir)
    {
        if (period[dir] > 0)
        {
            d[dir] -= period[dir]*std::round(d[dir]/period[dir]);
        }
    }
    return d;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::pressureLevels::seedSides(nearestObjects& nearest) const
{
    const cartesianMesh& grid = system_.grid;
    const cartesianBlock& block = nearest.block();
    const surfaceSet& surfaces = system_.objects.surfaces();
    const boundBox domain(grid.bounds());

    List<point> centres;
    scalarField radii;
    labelList objects;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (system_.objects.free(objecti))
        {
            const boundBox box(surfaces.bounds(objecti));
            objects.append(objecti);
            centres.append(box.midpoint());
            radii.append(0.5*cmptMax(box.span()));
        }
    }

    for (label samplei = 0; samplei < block.size(); ++samplei)
    {
        const labelVector ijk(block.ijk(samplei));
        bool atSide = false, taken = true;
        for (direction dir = 0; dir < grid.nDims(); ++dir)
        {
            const bool end = ijk[dir] == 0 || ijk[dir] == block.n()[dir] - 1;
            const label global = ijk[dir] + block.start()[dir];
            atSide = atSide || end;
            taken = taken
             && (end || ijk[dir] % sideStep == 0)
             && (
                    grid.period()[dir] > 0
                 || (global >= 0 && global < grid.globalN()[dir])
                );
        }
        if (!atSide || !taken)
        {
            continue;
        }
        forAll(objects, i)
        {
            const scalar d = mag
            (
                shortest(block.position(samplei) - centres[i], grid.period())
            );
            nearest.seed
            (
                samplei, objects[i],
                max(d - radii[i], 0.0)/grid.spacing()
            );
        }
    }
}


void Foam::fsi::pressureLevels::findNearest(nearestObjects& nearest) const
{
    const cartesianBlock& block = nearest.block();
    const surfaceSet& surfaces = system_.surfaces();
    const pointField& points = surfaces.points();
    const scalar h = block.spacing();
    forAll(points, nodei)
    {
        const label objecti = surfaces.original(surfaces.pointObject()[nodei]);
        if (!system_.objects.free(objecti))
        {
            continue;
        }
        labelVector ijk(labelVector::zero);
        vector off(points[nodei] - block.origin());
        for (direction dir = 0; dir < block.nDims(); ++dir)
        {
            const label i = std::floor(off[dir]/h + 0.5);
            ijk[dir] = i - block.start()[dir];
            off[dir] -= i*h;
        }
        for (direction dir = block.nDims(); dir < 3; ++dir)
        {
            off[dir] = 0;
        }
        if (block.contains(ijk))
        {
            nearest.seed(block.index(ijk), objecti, mag(off)/h);
        }
    }
    if (Pstream::parRun() || system_.grid.period() != vector::zero)
    {
        seedSides(nearest);
    }
    nearest.march();
}


void Foam::fsi::pressureLevels::setValues(const nearestObjects& nearest)
{
    const cartesianMesh& grid = system_.grid;
    const cartesianBlock inner(grid.cells());
    labelVector shift(beyond, beyond, grid.nDims() == 3 ? beyond : 0);

    const boolList& active = system_.geometry.activeCell();
    values_.setSize(active.size());
    forAll(values_, celli)
    {
        values_[celli] = cellValues();
        if (active[celli])
        {
            const labelVector ijk(inner.ijk(grid.blockIndex()[celli]) + shift);
            values_[celli] = valuesOf(nearest[nearest.block().index(ijk)]);
        }
    }

    // On walls that of the object with the largest part
    scalarField largest(values_.size(), Zero);
    for (const wallFace& w : system_.geometry.wallFaces())
    {
        for (const label celli : {w.lower, w.upper})
        {
            if
            (
                celli >= 0
             && w.area > largest[celli]
             && system_.objects.free(w.place.object)
            )
            {
                largest[celli] = w.area;
                values_[celli] = cellValues();
                values_[celli].object[0] = w.place.object;
                values_[celli].value[0] = 1;
            }
        }
    }
}


void Foam::fsi::pressureLevels::removeMean(scalarField& levels) const
{
    if (floating_)
    {
        const scalar mean = sum(levels)/nLevels_;
        forAll(levels, objecti)
        {
            if (system_.objects.free(objecti))
            {
                levels[objecti] -= mean;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::pressureLevels::pressureLevels(const fsiSystem& system)
:
    system_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::pressureLevels::update(const fvScalarMatrix& matrix)
{
    nLevels_ = 0;
    for (label i = 0; i < system_.objects.size(); ++i)
    {
        nLevels_ += system_.objects.free(i);
    }
    if (!active())
    {
        return;
    }
    nearestObjects nearest(system_.grid.cells(beyond));
    findNearest(nearest);
    setValues(nearest);
    sumFaces(matrix);
    factor(gMax(mag(matrix.upper())()));
}


void Foam::fsi::pressureLevels::correct
(
    scalarField& z,
    const scalarField& r
) const
{
    coarse_.setSize(system_.objects.size());
    coarse_ = 0;
    forAll(values_, celli)
    {
        const cellValues& v = values_[celli];
        for (label i = 0; i < nNearest && v.object[i] >= 0; ++i)
        {
            coarse_[v.object[i]] += v.value[i]*r[celli];
        }
    }
    sumOverRanks(coarse_);

    removeMean(coarse_);
    Eigen::Map<Eigen::VectorXd> coarse(coarse_.data(), coarse_.size());
    coarse = factor_.solve(coarse).eval();
    removeMean(coarse_);

    forAll(values_, celli)
    {
        const cellValues& v = values_[celli];
        for (label i = 0; i < nNearest && v.object[i] >= 0; ++i)
        {
            z[celli] += v.value[i]*coarse_[v.object[i]];
        }
    }
}


// ************************************************************************* //
