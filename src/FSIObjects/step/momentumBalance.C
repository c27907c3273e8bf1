// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumBalance.H"
#include "cellCut.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Action>
void Foam::fsi::momentumBalance::forCutCells(const Action& action) const
{
    const cartesianMesh& grid = geometry_.grid();
    const scalarField& distance = levelSet_.cellDistance();
    const UList<cellWall>& walls = geometry_.surfaceParts();
    label next = 0;
    for (label i = 0; i < walls.size(); i = next)
    {
        // The largest: which one comes first depends on the ranks
        const label celli = walls[i].cell;
        label largest = i;
        for (next = i; next < walls.size() && walls[next].cell == celli; ++next)
        {
            if (mag(walls[next].area) > mag(walls[largest].area))
            {
                largest = next;
            }
        }
        const cellWall& wall = walls[largest];
        const scalar d = distance[grid.haloIndex()[celli]];
        action
        (
            wall,
            closedPartOfCell(wall.area, d/grid.spacing(), grid.nDims())
        );
    }
}


void Foam::fsi::momentumBalance::setLayer
(
    const volVectorField& U,
    const vectorField& v,
    vectorField& layer
) const
{
    const boolList& fluid = geometry_.fluidCell();
    const scalarField& V = U.mesh().V();
    partialForces part(v.size());
    forCutCells([&](const cellWall& wall, const scalar closed)
    {
        if (fluid[wall.cell])
        {
            const vector slip(U[wall.cell] - wall.place.interpolate(v));
            wall.place.spread
            (
                part.mine(), vector(2*closed*V[wall.cell]*slip)
            );
        }
    });
    layer.transfer(part.collectWalls(bodies_.ranks()));
}


void Foam::fsi::momentumBalance::startWithFluid()
{
    const boolList& fluid = geometry_.fluidCell();
    const scalarField& V = geometry_.grid().mesh().V();
    partialForces part(wall_.size());
    forCutCells([&](const cellWall& wall, const scalar closed)
    {
        if (fluid[wall.cell])
        {
            wall.place.spread
            (
                part.mine(), vector::uniform(2*closed*V[wall.cell])
            );
        }
    });
    const vectorField& volume = part.collectWalls(bodies_.ranks());
    const labelList& start = bodies_.surfaces().pointStart();
    for (const label objecti : new_)
    {
        const label first = start[objecti];
        const label n = start[objecti + 1] - first;
        SubList<vector> layer(layer_, n, first);
        SubList<vector> wall(wall_, n, first);
        const scalar all = sum(SubList<vector>(volume, n, first)).x();
        if (all > 0)
        {
            const vector slip(sum(layer)/all);
            for (vector& v : wall)
            {
                v += slip;
            }
        }
        layer = Zero;
    }
    bodies_.ranks().spread({objectRanks::values::ofNodes(wall_)});
}


Foam::fsi::surfacePlace Foam::fsi::momentumBalance::kept
(
    surfacePlace place
) const
{
    const label start = bodies_.surfaces().pointStart()[place.object];
    for (label& nodei : place.nodes)
    {
        nodei -= nodei < 0 ? 0 : start;
    }
    place.object = bodies_.objectId(place.object);
    return place;
}


Foam::fsi::surfacePlace Foam::fsi::momentumBalance::moved
(
    surfacePlace place
) const
{
    place.object = bodies_.findObject(place.object);
    const label start = bodies_.surfaces().pointStart()[place.object];
    for (label& nodei : place.nodes)
    {
        nodei += nodei < 0 ? 0 : start;
    }
    return place;
}


void Foam::fsi::momentumBalance::addPassedCells
(
    const volVectorField& U,
    partialForces& nodal
)
{
    const boolList& fluid = geometry_.fluidCell();
    const scalarField& V = U.mesh().V();
    const vectorField& v = bodies_.surfaces().velocities();
    const auto add = [&](const label celli, const surfacePlace& place)
    {
        if (fluid[celli] != wasFluid_[celli])
        {
            const scalar volume = fluid[celli] ? -V[celli] : V[celli];
            const vector slip(U[celli] - place.interpolate(v));
            place.spread(nodal.mine(), vector(volume*slip));
            wasFluid_[celli] = fluid[celli];
        }
    };
    forAll(cells_, i)
    {
        add(cells_[i], moved(places_[i]));
    }
    forCutCells([&](const cellWall& wall, const scalar)
    {
        add(wall.cell, wall.place);
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::momentumBalance::momentumBalance
(
    population& bodies,
    const interfaceGeometry& geometry,
    const levelSetUpdate& levelSet,
    const scalar density
)
:
    bodies_(bodies),
    geometry_(geometry),
    levelSet_(levelSet),
    density_(density),
    known_(false)
{
    renew();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::momentumBalance::renew()
{
    nodeLayout::groupNodal debt(bodies_.groups().size());
    forAll(debt, groupi)
    {
        debt[groupi] = bodies_.groups()[groupi].owedImpulse();
    }
    bodies_.layout().toSurface(debt, owed_);
    payment_.setSize(owed_.size());
    payment_ = Zero;
    kept_ = owed_;
    known_ = false;
    new_.clear();
    for (label objecti = 0; objecti < bodies_.size(); ++objecti)
    {
        const bodyGroup& group = bodies_.groups()[bodies_.objectGroup(objecti)];
        if (group.isNew(bodies_.objectCopy(objecti)))
        {
            new_.append(objecti);
        }
    }
}


void Foam::fsi::momentumBalance::pay(const stepLength& step)
{
    payment_ = (part/step.tau)*owed_;
    owed_ -= step.tau*payment_;
    kept_ -= step.tau*payment_;
}


void Foam::fsi::momentumBalance::begin(const volVectorField& U)
{
    if (!known_)
    {
        wall_ = bodies_.surfaces().velocities();
        setLayer(U, wall_, layer_);
        startWithFluid();
        known_ = true;
    }
}


void Foam::fsi::momentumBalance::owe
(
    const vectorField& force,
    const stepLength& step
)
{
    owed_ += step.tau*force;
}


void Foam::fsi::momentumBalance::beginMove
(
    const volVectorField& U,
    const vectorField& v,
    const stepLength& step
)
{
    const boolList& fluid = geometry_.fluidCell();
    const scalarField& V = U.mesh().V();
    const vectorField gain(v - wall_);
    wasFluid_ = fluid;
    cells_.clear();
    places_.clear();
    partialForces inertia(gain.size());
    forCutCells([&](const cellWall& wall, const scalar closed)
    {
        const label celli = wall.cell;
        const scalar more = fluid[celli] ? closed : closed - 1;
        const vector dv(wall.place.interpolate(gain));
        wall.place.spread(inertia.mine(), vector(more*V[celli]*dv));
        if (fluid[celli])
        {
            cells_.append(celli);
            places_.append(kept(wall.place));
        }
    });
    owed_ += perStep(step)*inertia.collectWalls(bodies_.ranks());
}


void Foam::fsi::momentumBalance::endMove
(
    const volVectorField& U,
    const stepLength& step
)
{
    const vectorField& v = bodies_.surfaces().velocities();
    partialForces passed(v.size());
    addPassedCells(U, passed);

    vectorField layer;
    setLayer(U, v, layer);
    const vectorField& gain = passed.collectWalls(bodies_.ranks());
    owed_ += perStep(step)*(gain + layer - layer_);
    layer_ = layer;
    wall_ = v;
}


Foam::vectorField Foam::fsi::momentumBalance::close(const stepLength& step)
{
    nodeLayout::groupNodal debt;
    bodies_.layout().toBoundary(owed_, debt);
    forAll(debt, groupi)
    {
        bodies_.groups()[groupi].owedImpulse() = debt[groupi];
    }
    const vectorField force((owed_ - kept_)/step.tau);
    kept_ = owed_;
    return force;
}


// ************************************************************************* //
