// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmFaces.H"
#include "levelSetUpdate.H"
#include "swapCoupledCells.H"
#include "wallTreatment.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Largest thickness of a film, in cells: the mesh resolves wider ones
static const scalar widest = 2.5;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::filmFaces::keepOpen
(
    const filmSearch::pair& p,
    filmFace& film
) const
{
    bool crosses = true;
    for (label side = 0; side < 2; ++side)
    {
        const bool covers = film.closed[side] > 2*smallestOpenness;
        crosses = crosses && (p.objects[side] < 0 || covers);
    }
    const scalar least = min(film.gap/grid_.spacing(), scalar(0.5));
    const scalar closed = film.closed[0] + film.closed[1];
    if (crosses && closed > 1 - least)
    {
        for (scalar& part : film.closed)
        {
            part *= (1 - least)/closed;
        }
    }
}


void Foam::fsi::filmFaces::place
(
    const filmSearch::pair& p,
    const filmMeasures& m,
    filmFace& film
) const
{
    film.dir = grid_.faceDirection(film.face);
    for (label side = 0; side < 2; ++side)
    {
        film.origins[side].cut = false;
        film.closed[side] = 0;
        if (p.objects[side] >= 0)
        {
            m.setCut(side, film);
        }
    }

    const point middle(m.openMiddle(film));
    FixedList<scalar, 2> away;
    for (label side = 0; side < 2; ++side)
    {
        vector normal;
        away[side] = m.setSide
        (
            p, middle, side, film.sides[side], film.origins[side].surface,
            normal
        );
        away[side] = max(away[side], scalar(0));
    }
    const scalar least = thinnest*grid_.spacing();
    film.gap = max(away[0] + away[1], least);
    film.middle = away[0]/max(away[0] + away[1], VSMALL);
    m.setProfile(p, middle, least, film);
    keepOpen(p, film);
}


void Foam::fsi::filmFaces::add(const filmFace& film)
{
    if (film.open() > smallestOpenness)
    {
        faces_.append(film);
    }
    else
    {
        const bool second = film.closed[1] > film.closed[0];
        closed_.insert(film.face, film.origins[second]);
    }
}


void Foam::fsi::filmFaces::agree()
{
    const label nInternal = grid_.mesh().nInternalFaces();
    onBoundary_.setSize(grid_.mesh().nFaces() - nInternal);
    onBoundary_ = vector(GREAT, 0, 0);
    for (const filmFace& film : faces_)
    {
        if (film.face >= nInternal)
        {
            onBoundary_[film.face - nInternal] =
                vector(film.gap, film.resistance, 0);
        }
    }
    SubList<vector> boundary(onBoundary_, onBoundary_.size());
    syncCoupledFaces(grid_.mesh(), boundary, maxEqOp<vector>());
    for (filmFace& film : faces_)
    {
        if (film.face >= nInternal)
        {
            const vector& agreed = onBoundary_[film.face - nInternal];
            film.gap = agreed.x();
            film.resistance = agreed.y();
        }
    }
}


void Foam::fsi::filmFaces::dropWide()
{
    const scalar limit = widest*grid_.spacing();
    if (faces_.size() && place_.empty())
    {
        place_.setSize(grid_.mesh().nFaces(), -1);
    }
    label n = 0;
    for (const filmFace& film : faces_)
    {
        if (film.gap < limit)
        {
            place_[film.face] = n;
            faces_[n++] = film;
        }
    }
    faces_.setSize(n);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmFaces::filmFaces
(
    const cartesianMesh& grid,
    const wallTreatment& wall
)
:
    grid_(grid),
    wall_(wall),
    search_(grid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::filmFaces::used(const levelSetUpdate& levelSet) const
{
    return wall_.opensFilms() && levelSet.knowsPairs();
}


void Foam::fsi::filmFaces::update
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces,
    const UList<label>& nearFaces
)
{
    for (const filmFace& film : faces_)
    {
        place_[film.face] = -1;
    }
    faces_.clear();
    closed_.clear();
    if (!used(levelSet))
    {
        return;
    }
    const polyMesh& mesh = grid_.mesh();
    const labelList& owner = mesh.faceOwner();
    const labelList& haloIndex = grid_.haloIndex();
    const surfaceSamples atCorners(surfaceSamples::corners(levelSet, grid_));
    const surfaceSamples atCentres(surfaceSamples::centres(levelSet, grid_));
    const scalar limit = 1.01*widest*grid_.spacing();
    const labelList& second = levelSet.centreSamples().secondFace();
    curvedSurface curved(surfaces);
    filmSearch::pair p;
    for (const label facei : nearFaces)
    {
        const label here = haloIndex[owner[facei]];
        const label there = here + grid_.stepAcross(facei);
        const bool two = second[here] >= 0 || second[there] >= 0;
        if
        (
            (!two && !search_.besideWall(owner[facei]))
         || (
                facei >= mesh.nInternalFaces()
             && !mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(facei)]
               .coupled()
            )
        )
        {
            continue;
        }
        filmSearch::setSamples
        (
            grid_, {&atCorners, &atCentres}, facei, here, p
        );
        const scalar between = two ? filmSearch::choose(surfaces, p) : GREAT;
        const bool wall =
            search_.besideWall(owner[facei])
         && search_.chooseWall(grid_, surfaces, facei, min(between, limit), p);
        if (!wall && between >= limit)
        {
            continue;
        }
        const filmMeasures m(grid_, surfaces, curved, atCorners.block, p);
        if (m.meanGap() < limit && m.covered(0, 0) < 1 && m.covered(1, 0) < 1)
        {
            filmFace film;
            film.face = facei;
            place(p, m, film);
            add(film);
        }
    }
    agree();
    dropWide();
}


// ************************************************************************* //
