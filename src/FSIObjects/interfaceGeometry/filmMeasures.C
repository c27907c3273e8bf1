// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmMeasures.H"
#include "cartesianMesh.H"
#include "edgeCuts.H"
#include "filmFaces.H"
#include "openArea.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmMeasures::filmMeasures
(
    const cartesianMesh& grid,
    const surfaceSet& surfaces,
    curvedSurface& curved,
    const cartesianBlock& corners,
    const filmSearch::pair& p
)
:
    grid(grid),
    surfaces(surfaces),
    curved(curved),
    corners(corners),
    nCorners(p.nSamples - 2)
{
    for (label i = 0; i < p.nSamples; ++i)
    {
        bool known = true;
        for (label side = 0; side < 2; ++side)
        {
            known = filmSearch::from
            (
                grid, surfaces, p, i, side, distances[side][i], faces[side][i]
            ) && known;
        }
        gaps[i] = known ? distances[0][i] + distances[1][i] : GREAT;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::filmMeasures::way
(
    const point& from,
    const point& to
) const
{
    vector change(to - from);
    if (surfaces.nDims() == 2)
    {
        change.z() = 0;
    }
    return change;
}


Foam::scalar Foam::fsi::filmMeasures::nearest
(
    const point& p,
    const label side,
    filmSide& to,
    label& face,
    vector& normal
) const
{
    const UList<label> known
    (
        const_cast<label*>(faces[side].cdata()), nCorners + 2
    );
    to.place = nearestPlace(surfaces, p, known, face);
    FixedList<scalar, 3> weights;
    const vector out(way(surfaces.nearestOnFace(face, p, weights), p));
    return curved.distance(face, weights, out, normal);
}


Foam::scalar Foam::fsi::filmMeasures::from
(
    const point& p,
    const label side
) const
{
    filmSide to;
    label face;
    vector normal;
    return nearest(p, side, to, face, normal);
}


Foam::FixedList<Foam::scalar, 4> Foam::fsi::filmMeasures::moved
(
    const label side,
    const scalar more
) const
{
    FixedList<scalar, 4> d(Zero);
    for (label i = 0; i < nCorners; ++i)
    {
        d[i] = distances[side][i] + more;
    }
    return d;
}


Foam::scalar Foam::fsi::filmMeasures::covered
(
    const label side,
    const scalar more
) const
{
    const FixedList<scalar, 4> d(moved(side, more));
    return nCorners == 2 ? 1 - openSegment(d[0], d[1]) : 1 - openSquare(d);
}


Foam::scalar Foam::fsi::filmMeasures::meanGap() const
{
    scalar sum = 0;
    label n = 0;
    for (label i = 0; i < nCorners + 2; ++i)
    {
        if (gaps[i] < GREAT)
        {
            sum += gaps[i];
            ++n;
        }
    }
    return sum/max(n, 1);
}


Foam::scalar Foam::fsi::filmMeasures::setSide
(
    const filmSearch::pair& p,
    const point& x,
    const label side,
    filmSide& to,
    label& face,
    vector& normal
) const
{
    if (p.objects[side] >= 0)
    {
        return nearest(x, side, to, face, normal);
    }
    face = -1;
    to.wallFace = p.wallFace;
    const direction d = grid.faceDirection(p.wallFace);
    normal = Zero;
    normal[d] = grid.faceAlong(p.wallFace) ? -1 : 1;
    return normal & (x - grid.mesh().faceCentres()[p.wallFace]);
}


Foam::scalar Foam::fsi::filmMeasures::across
(
    const filmSearch::pair& p,
    point& x,
    filmEnd& there
) const
{
    FixedList<scalar, 2> d;
    for (label i = 0; i < 3; ++i)
    {
        for (label side = 0; side < 2; ++side)
        {
            label face;
            d[side] = setSide
            (
                p, x, side, there.sides[side], face, there.normals[side]
            );
        }
        const vector over(there.normals[0] - there.normals[1]);
        x += 0.5*(d[1] - d[0])*over/max(mag(over), VSMALL);
    }
    // Between walls that open by the angle 2 alpha
    const scalar sine = 0.5*mag(there.normals[0] + there.normals[1]);
    return (d[0] + d[1])/Foam::cbrt(1 + 0.4*sqr(sine));
}


void Foam::fsi::filmMeasures::setProfile
(
    const filmSearch::pair& p,
    const point& middle,
    const scalar least,
    filmFace& film
) const
{
    const label lower = grid.faceAlong(film.face) ? 0 : 1;
    FixedList<point, 2> at;
    FixedList<scalar, 3> sampled, thickness;
    bool known = true;
    for (label k = 0; k < 2; ++k)
    {
        const label samplei = nCorners + (k == 0 ? lower : 1 - lower);
        at[k] = p.samples[samplei].position();
        thickness[2*k] = across(p, at[k], film.ends[k]);
        const FixedList<vector, 2>& n = film.ends[k].normals;
        known = known && gaps[samplei] < GREAT && (n[0] & n[1]) < -0.5;
        sampled[2*k] = gaps[samplei] < GREAT ? gaps[samplei] : film.gap;
    }
    const vector along(way(at[0], at[1]));
    point between(0.5*(at[0] + at[1]));
    const vector toFace(way(between, middle));
    filmEnd unused;
    thickness[1] = across(p, between, unused);
    sampled[1] = film.gap;
    const scalar h = grid.spacing();
    // A face across which the film lies is not between the ends
    const scalar ratio = (toFace & along)/max(magSqr(along), VSMALL);
    const scalar xf = max(min(ratio, scalar(0.5)), scalar(-0.5));
    known = known && mag(along) < 1.5*h;
    const scalar area = film.gap*h*(grid.nDims() - 1);
    film.perOpening = known ? magSqr(along)/area : 0;
    film.setProfile(known ? thickness : sampled, xf, least);
}


void Foam::fsi::filmMeasures::setCut
(
    const label side,
    filmFace& film
) const
{
    const FixedList<point, 4> at(corners.positions(grid.cornersOf(film.face)));
    wallOrigin& origin = film.origins[side];
    origin.cut = false;
    origin.middle = grid.mesh().faceCentres()[film.face];
    scalar error = 0;
    for (label way = 0; way < 2; ++way)
    {
        const edgeCuts cuts(moved(side, error), at, nCorners);
        if (cuts.n == 0)
        {
            break;
        }
        origin.cut = true;
        // Mean over a cut by Simpson's rule
        origin.middle = cuts.middle();
        scalar more = 0;
        for (label i = 0; i < cuts.n; ++i)
        {
            more += from(cuts.at[i], side)/cuts.n;
        }
        error += nCorners == 2 ? more : (more + 2*from(origin.middle, side))/3;
    }
    // At a corner of the face the surface keeps its place
    const scalar least = origin.cut ? filmFaces::smallestOpenness : scalar(0);
    film.closed[side] = max(covered(side, error), least);
}


Foam::point Foam::fsi::filmMeasures::openMiddle
(
    const filmFace& film
) const
{
    const FixedList<label, 4> around = grid.cornersOf(film.face);
    point sum(Zero);
    scalar n = 0;
    for (label a = 0; a < nCorners; ++a)
    {
        if (distances[0][a] > 0 && distances[1][a] >= 0)
        {
            sum += corners.position(around[a]);
            n += 1;
        }
    }
    for (const wallOrigin& origin : film.origins)
    {
        // It has two ends in 3D
        if (origin.cut)
        {
            sum += nCorners/2*origin.middle;
            n += nCorners/2;
        }
    }
    return n > 0 ? point(sum/n) : grid.mesh().faceCentres()[film.face];
}


// ************************************************************************* //
