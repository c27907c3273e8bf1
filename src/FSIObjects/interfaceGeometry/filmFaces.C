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

//- Least cosine between the normals of two surfaces that do not face each other
static const scalar sideways = -0.1;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::filmFaces::setSamples
(
    const FixedList<const surfaceSamples*, 2>& all,
    const label facei,
    const label here,
    pair& p
) const
{
    const label nCorners = grid_.nDims() == 2 ? 2 : 4;
    const FixedList<label, 4> corners = grid_.cornersOf(facei);
    for (label i = 0; i < nCorners; ++i)
    {
        p.samples[i] = {all[0], corners[i]};
    }
    for (const label at : {here, here + grid_.stepAcross(facei)})
    {
        p.samples[nCorners + (at != here)] = {all[1], at};
    }
    p.nSamples = nCorners + 2;
}


Foam::scalar Foam::fsi::filmFaces::choose
(
    const surfaceSet& surfaces,
    pair& p
)
{
    scalar least = GREAT;
    for (label i = 0; i < p.nSamples; ++i)
    {
        const surfaceSample& s = p.samples[i];
        const label nearest = s.nearestFace();
        const label second = s.secondFace();
        if (nearest < 0)
        {
            // A sample beyond the band: there is no narrow film
            return GREAT;
        }
        if (second < 0)
        {
            continue;
        }
        const vector normal(surfaces.areaNormal(nearest));
        const vector other(surfaces.areaNormal(second));
        if ((normal & other) > sideways*mag(normal)*mag(other))
        {
            // One surface goes on in the other, as in a periodic image
            continue;
        }
        const label object = surfaces.faceObject()[second];
        scalar away;
        label face;
        if
        (
            s.distance() + s.secondDistance() < least
         && s.from(surfaces, object, away, face)
        )
        {
            least = s.distance() + away;
            p.objects[0] = surfaces.faceObject()[nearest];
            p.objects[1] = object;
        }
    }
    for (label i = 0; i < p.nSamples; ++i)
    {
        const surfaceSample& s = p.samples[i];
        if
        (
            s.distance() <= 0
         && !p.objects.found(surfaces.faceObject()[s.nearestFace()])
        )
        {
            // A third object covers a part of the face
            return GREAT;
        }
    }
    return least;
}


void Foam::fsi::filmFaces::measure
(
    const surfaceSet& surfaces,
    const pair& p,
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
            p.samples[i].from(surfaces, p.objects[0], d[0], face);
        const bool second =
            p.samples[i].from(surfaces, p.objects[1], d[1], face);
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
        film.closed[side] =
            1 - (nCorners == 2 ? openSegment(d[0], d[1]) : openSquare(d));
        crosses = crosses && film.closed[side] > 0;
    }

    // A film that crosses the face is not closed by errors of the corners'
    // distances
    const scalar least =
        crosses ? min(width, scalar(0.5)) : 0;
    const scalar closed = film.closed[0] + film.closed[1];
    if (crosses && closed > 1 - least)
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
    place_(grid.mesh().nFaces(), -1)
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
    pair p;
    for (const label facei : nearFaces)
    {
        const label here = haloIndex[owner[facei]];
        if
        (
            second[here] < 0
         || (
                facei >= mesh.nInternalFaces()
             && !patches[patches.whichPatch(facei)].coupled()
            )
        )
        {
            continue;
        }
        setSamples({&atCorners, &atCentres}, facei, here, p);
        if (choose(surfaces, p) >= limit)
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
