// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmShares.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::filmShares::setCells()
{
    const boolList& fluid = geometry_.fluidCell();
    solid_.clear();
    links_.clear();
    for (const filmFace& film : geometry_.films().faces())
    {
        for (const label celli : geometry_.grid().cellsBeside(film.face))
        {
            if (celli >= 0 && fluid[celli])
            {
                links_.insert(celli, Map<scalar>());
            }
            else if (celli >= 0)
            {
                solid_.insert(celli, vector(Zero));
                solid_[celli][film.dir] += 1;
            }
        }
    }
    for (const wallLink& link : geometry_.wallLinks())
    {
        auto found = links_.find(link.cell);
        if (found != links_.end())
        {
            (*found)(link.place.object) += link.conductance;
        }
    }
}


Foam::scalar Foam::fsi::filmShares::linked
(
    const filmSide& side,
    const label celli
) const
{
    if (!side.isWall())
    {
        const Map<scalar>& links = links_[celli];
        const auto found = links.find(side.place.object);
        return found == links.end() ? 0 : *found;
    }
    const cartesianMesh& grid = geometry_.grid();
    const scalar h = grid.spacing();
    const vector away
    (
        grid.mesh().C()[celli] - grid.mesh().faceCentres()[side.wallFace]
    );
    const bool beside = mag(away[grid.faceDirection(side.wallFace)]) < h;
    return beside ? 2*grid.faceArea()/h : 0;
}


void Foam::fsi::filmShares::add
(
    const filmFace& film,
    const label celli
)
{
    const scalar open = film.open();
    FixedList<scalar, 2> part
    ({
        film.closed[0] + 0.5*open, film.closed[1] + 0.5*open
    });
    if (geometry_.fluidCell()[celli])
    {
        const scalar first = linked(film.sides[0], celli);
        const scalar second = linked(film.sides[1], celli);
        if (first <= 0 || second <= 0)
        {
            return;
        }
        part[0] = 0.5*(first/(first + second) - part[0]);
        part[1] = -part[0];
    }
    forAll(film.sides, i)
    {
        if (!film.sides[i].isWall())
        {
            shares_.append
            ({
                celli, film.dir, film.sides[i].place, part[i]
            });
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmShares::filmShares(const interfaceGeometry& geometry)
:
    geometry_(geometry)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmShares::update()
{
    setCells();
    shares_.clear();
    for (const filmFace& film : geometry_.films().faces())
    {
        for (const label celli : geometry_.grid().cellsBeside(film.face))
        {
            if (celli >= 0)
            {
                add(film, celli);
            }
        }
    }
    for (const wallFace& w : geometry_.wallFaces())
    {
        for (const label celli : {w.lower, w.upper})
        {
            auto found = solid_.find(celli);
            if (!w.film && found != solid_.end() && (*found)[w.dir] > 0)
            {
                const scalar part = w.area/geometry_.grid().faceArea();
                shares_.append({celli, w.dir, w.place, part});
                (*found)[w.dir] += part;
            }
        }
    }
    for (share& s : shares_)
    {
        const auto found = solid_.find(s.cell);
        s.part /= found == solid_.end() ? 1 : -(*found)[s.dir];
    }
}


Foam::vector Foam::fsi::filmShares::rest
(
    const label celli,
    const vector& gradient
) const
{
    vector rest(gradient);
    const auto found = solid_.find(celli);
    for (direction d = 0; d < 3 && found != solid_.end(); ++d)
    {
        rest[d] = (*found)[d] > 0 ? 0 : rest[d];
    }
    return rest;
}


void Foam::fsi::filmShares::addForce(const vectorField& g, vectorField& f) const
{
    const scalar volume = geometry_.grid().cellVolume();
    for (const share& s : shares_)
    {
        s.place.spread(f, s.dir, s.part*volume*g[s.cell][s.dir]);
    }
}


// ************************************************************************* //
