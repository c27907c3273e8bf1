// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmShares.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::FixedList<Foam::label, 2> Foam::fsi::filmShares::cellsBeside
(
    const label facei
) const
{
    const fvMesh& mesh = geometry_.grid().mesh();
    const boolList& active = geometry_.activeCell();
    FixedList<label, 2> cells
    ({
        mesh.faceOwner()[facei],
        facei < mesh.nInternalFaces() ? mesh.faceNeighbour()[facei] : -1
    });
    for (label& celli : cells)
    {
        celli = celli >= 0 && active[celli] ? celli : -1;
    }
    return cells;
}


void Foam::fsi::filmShares::count()
{
    const boolList& fluid = geometry_.fluidCell();
    solid_.clear();
    links_.clear();
    for (const filmFace& film : geometry_.films().faces())
    {
        for (const label celli : cellsBeside(film.face))
        {
            if (celli >= 0 && fluid[celli])
            {
                links_.insert(celli, Map<scalar>());
            }
            else if (celli >= 0)
            {
                solid_(key(celli, film.dir)) += 1;
            }
        }
    }
    for (const wallFace& w : geometry_.wallFaces())
    {
        for (const label celli : {w.lower, w.upper})
        {
            auto found = solid_.find(key(celli, w.dir));
            if (celli >= 0 && !w.film && found != solid_.end())
            {
                *found += w.area/geometry_.grid().faceArea();
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
    const scalar open = 1 - (film.closed[0] + film.closed[1]);
    FixedList<scalar, 2> part
    ({
        film.closed[0] + 0.5*open, film.closed[1] + 0.5*open
    });
    const auto faces = solid_.find(key(celli, film.dir));
    if (faces != solid_.end())
    {
        for (scalar& x : part)
        {
            x *= -1/(*faces);
        }
    }
    else
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
    shares_.clear();
    count();
    for (const filmFace& film : geometry_.films().faces())
    {
        for (const label celli : cellsBeside(film.face))
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
            const auto faces = solid_.find(key(celli, w.dir));
            if (celli >= 0 && !w.film && faces != solid_.end())
            {
                const scalar part = w.area/geometry_.grid().faceArea();
                shares_.append({celli, w.dir, w.place, -part/(*faces)});
            }
        }
    }
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
