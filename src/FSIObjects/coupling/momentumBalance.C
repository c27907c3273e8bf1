// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumBalance.H"
#include "cellCut.H"
#include "levelSetUpdate.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Action>
void Foam::fsi::momentumBalance::forCutCells(const Action& action) const
{
    const cartesianMesh& grid = system_.grid;
    const scalarField& distance = system_.levelSet->cellDistance();
    const UList<cellWall>& walls = system_.geometry.surfaceParts();
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
    const boolList& fluid = system_.geometry.fluidCell();
    const scalarField& V = U.mesh().V();
    layer.setSize(v.size());
    layer = Zero;
    forCutCells([&](const cellWall& wall, const scalar closed)
    {
        if (fluid[wall.cell])
        {
            const vector slip(U[wall.cell] - wall.place.interpolate(v));
            wall.place.spread(layer, vector(2*closed*V[wall.cell]*slip));
        }
    });
    sumOverRanks(layer);
}


void Foam::fsi::momentumBalance::addPassedCells
(
    const volVectorField& U,
    vectorField& nodal
)
{
    const boolList& fluid = system_.geometry.fluidCell();
    const scalarField& V = U.mesh().V();
    const vectorField& v = system_.objects.surfaces().velocities();
    const auto add = [&](const label celli, const surfacePlace& place)
    {
        if (fluid[celli] != wasFluid_[celli])
        {
            const scalar volume = fluid[celli] ? -V[celli] : V[celli];
            const vector slip(U[celli] - place.interpolate(v));
            place.spread(nodal, vector(volume*slip));
            wasFluid_[celli] = fluid[celli];
        }
    };
    forAll(cells_, i)
    {
        add(cells_[i], places_[i]);
    }
    forCutCells([&](const cellWall& wall, const scalar)
    {
        add(wall.cell, wall.place);
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::momentumBalance::momentumBalance(fsiSystem& system)
:
    system_(system),
    known_(false)
{
    renew();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::momentumBalance::renew()
{
    population& objects = system_.objects;
    fsiSystem::groupNodal debt(objects.groups().size());
    forAll(debt, groupi)
    {
        debt[groupi] = objects.groups()[groupi].owedImpulse();
    }
    objects.layout().toSurface(debt, owed_);
    payment_.setSize(owed_.size());
    payment_ = Zero;
    kept_ = owed_;
    known_ = false;
}


void Foam::fsi::momentumBalance::pay()
{
    payment_ = (part/system_.stepTime())*owed_;
    owed_ -= system_.stepTime()*payment_;
    kept_ -= system_.stepTime()*payment_;
}


void Foam::fsi::momentumBalance::begin(const volVectorField& U)
{
    if (!known_)
    {
        wall_ = system_.objects.surfaces().velocities();
        setLayer(U, wall_, layer_);
        known_ = true;
    }
}


void Foam::fsi::momentumBalance::owe(const vectorField& force)
{
    owed_ += system_.stepTime()*force;
}


void Foam::fsi::momentumBalance::beginMove(const volVectorField& U)
{
    begin(U);
    const boolList& fluid = system_.geometry.fluidCell();
    const scalarField& V = U.mesh().V();
    const vectorField gain
    (
        system_.objects.surfaces().velocities() - wall_
    );
    wasFluid_ = fluid;
    cells_.clear();
    places_.clear();
    vectorField inertia(gain.size(), Zero);
    forCutCells([&](const cellWall& wall, const scalar closed)
    {
        const label celli = wall.cell;
        const scalar more = fluid[celli] ? closed : closed - 1;
        const vector dv(wall.place.interpolate(gain));
        wall.place.spread(inertia, vector(more*V[celli]*dv));
        if (fluid[celli])
        {
            cells_.append(celli);
            places_.append(wall.place);
        }
    });
    sumOverRanks(inertia);
    owed_ += system_.fluidDensity*inertia;
}


void Foam::fsi::momentumBalance::endMove(const volVectorField& U)
{
    const vectorField& v = system_.objects.surfaces().velocities();
    vectorField passed(v.size(), Zero);
    addPassedCells(U, passed);
    sumOverRanks(passed);

    vectorField layer;
    setLayer(U, v, layer);
    owed_ += system_.fluidDensity*(passed + layer - layer_);
    layer_ = layer;
    wall_ = v;
}


Foam::vectorField Foam::fsi::momentumBalance::close()
{
    fsiSystem::groupNodal debt;
    system_.objects.layout().toBoundary(owed_, debt);
    forAll(debt, groupi)
    {
        system_.objects.groups()[groupi].owedImpulse() = debt[groupi];
    }
    const vectorField force((owed_ - kept_)/system_.stepTime());
    kept_ = owed_;
    return force;
}


// ************************************************************************* //
