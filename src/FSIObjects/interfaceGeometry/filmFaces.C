// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmFaces.H"
#include "levelSetUpdate.H"
#include "openArea.H"
#include "swapCoupledCells.H"
#include "wallTreatment.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Largest thickness of a film, in cells: the mesh resolves wider ones
static const scalar widest = 1.5;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::filmFaces::measure
(
    const surfaceSet& surfaces,
    const filmSearch::pair& p,
    filmFace& film
) const
{
    const label nCorners = p.nSamples - 2;
    FixedList<FixedList<scalar, 4>, 2> corners;
    scalar sum = 0;
    label n = 0;
    for (label i = 0; i < p.nSamples; ++i)
    {
        FixedList<scalar, 2> d;
        label face;
        const bool first =
            filmSearch::from(grid_, surfaces, p, i, 0, d[0], face);
        const bool second =
            filmSearch::from(grid_, surfaces, p, i, 1, d[1], face);
        if (first && second)
        {
            sum += d[0] + d[1];
            ++n;
        }
        if (i < nCorners)
        {
            corners[0][i] = d[0];
            corners[1][i] = d[1];
        }
    }
    film.gap = sum/n;
    const scalar width = max(film.gap/grid_.spacing(), thinnest);
    bool crosses = true;
    for (label side = 0; side < 2; ++side)
    {
        const FixedList<scalar, 4>& d = corners[side];
        const bool wall = p.objects[side] < 0;
        film.closed[side] =
            wall
          ? 0
          : 1 - (nCorners == 2 ? openSegment(d[0], d[1]) : openSquare(d));
        crosses = crosses && (wall || film.closed[side] > 0);
    }

    // A film that crosses the face is not closed by errors of the corners'
    // distances
    const scalar least =
        crosses ? min(width, scalar(0.5)) : smallestOpenness;
    const scalar closed = film.closed[0] + film.closed[1];
    if (closed > 1 - least && (crosses || closed < 1))
    {
        for (scalar& part : film.closed)
        {
            part *= (1 - least)/closed;
        }
    }
}


void Foam::fsi::filmFaces::agree()
{
    const label nInternal = grid_.mesh().nInternalFaces();
    onBoundary_.setSize(grid_.mesh().nFaces() - nInternal);
    onBoundary_ = GREAT;
    for (const filmFace& film : faces_)
    {
        if (film.face >= nInternal)
        {
            onBoundary_[film.face - nInternal] = film.gap;
        }
    }
    SubList<scalar> boundary(onBoundary_, onBoundary_.size());
    syncCoupledFaces(grid_.mesh(), boundary, maxEqOp<scalar>());
    const scalar limit = widest*grid_.spacing();
    label n = 0;
    for (filmFace& film : faces_)
    {
        if (film.face >= nInternal)
        {
            film.gap = onBoundary_[film.face - nInternal];
        }
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
    place_(grid.mesh().nFaces(), -1),
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
    if (!used(levelSet))
    {
        return;
    }
    const polyMesh& mesh = grid_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const labelList& owner = mesh.faceOwner();
    const labelList& haloIndex = grid_.haloIndex();
    const surfaceSamples atCorners(surfaceSamples::corners(levelSet, grid_));
    const surfaceSamples atCentres(surfaceSamples::centres(levelSet, grid_));
    const scalar limit = 1.01*widest*grid_.spacing();
    const labelList& second = levelSet.centreSamples().secondFace();
    filmSearch::pair p;
    for (const label facei : nearFaces)
    {
        const label here = haloIndex[owner[facei]];
        const bool two = second[here] >= 0;
        if
        (
            (!two && !search_.besideWall(owner[facei]))
         || (
                facei >= mesh.nInternalFaces()
             && !patches[patches.whichPatch(facei)].coupled()
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
         && search_.chooseWall
            (grid_, surfaces, facei, min(between, limit), p);
        if (!wall && between >= limit)
        {
            continue;
        }
        filmFace film;
        film.face = facei;
        film.dir = grid_.faceDirection(facei);
        measure(surfaces, p, film);
        if (film.gap < limit && film.closed[0] + film.closed[1] < 1)
        {
            place(surfaces, atCorners.block, p, film);
            faces_.append(film);
        }
    }
    agree();
}


// ************************************************************************* //
