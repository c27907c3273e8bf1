// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmMeasures.H"
#include "cartesianMesh.H"
#include "edgeCuts.H"
#include "openArea.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmMeasures::filmMeasures
(
    const cartesianMesh& grid,
    const surfaceSet& surfaces,
    const cartesianBlock& corners,
    const filmSearch::pair& p
)
:
    grid(grid),
    surfaces(surfaces),
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


Foam::fsi::surfacePlace Foam::fsi::filmMeasures::nearest
(
    const point& p,
    const label side,
    label& face
) const
{
    const UList<label> known
    (
        const_cast<label*>(faces[side].cdata()), nCorners + 2
    );
    return nearestPlace(surfaces, p, known, face);
}


Foam::scalar Foam::fsi::filmMeasures::from
(
    const point& p,
    const label side
) const
{
    label face;
    nearest(p, side, face);
    FixedList<scalar, 3> weights;
    const point at(surfaces.nearestOnFace(face, p, weights));
    const vector to(way(at, p));
    return (to & surfaces.areaNormal(face)) < 0 ? -mag(to) : mag(to);
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


Foam::scalar Foam::fsi::filmMeasures::resistance
(
    const scalar gap,
    const scalar least
) const
{
    // Simpson's rule
    scalar sum = 4/sqr(gap);
    scalar weight = 4;
    for (label i = nCorners; i < nCorners + 2; ++i)
    {
        if (gaps[i] < GREAT)
        {
            sum += 1/sqr(max(gaps[i], least));
            weight += 1;
        }
    }
    return sum/weight;
}


void Foam::fsi::filmMeasures::setEnd
(
    const filmSearch::pair& p,
    const label samplei,
    const filmFace& film,
    filmEnd& end
) const
{
    const surfaceSample& sample = p.samples[samplei];
    const point centre(sample.all->block.position(sample.at));
    for (label side = 0; side < 2; ++side)
    {
        end.sides[side] = film.sides[side];
        vector& normal = end.normals[side];
        if (p.objects[side] < 0)
        {
            const direction d = grid.faceDirection(p.wallFace);
            const point& wall = grid.mesh().faceCentres()[p.wallFace];
            normal = Zero;
            normal[d] = centre[d] > wall[d] ? 1 : -1;
            continue;
        }
        label face;
        FixedList<scalar, 3> weights;
        end.sides[side].place = nearest(centre, side, face);
        const vector area(surfaces.areaNormal(face));
        normal = way(surfaces.nearestOnFace(face, centre, weights), centre);
        if (mag(normal) < 1e-3*grid.spacing())
        {
            normal = area;
        }
        normal *= ((normal & area) < 0 ? -1 : 1)/max(mag(normal), VSMALL);
    }
}


void Foam::fsi::filmMeasures::setProfile
(
    const filmSearch::pair& p,
    const scalar least,
    filmFace& film
) const
{
    film.perOpening = 0;
    film.resistance = resistance(film.gap, least);
    if (gaps[nCorners] >= GREAT || gaps[nCorners + 1] >= GREAT)
    {
        return;
    }
    const label lower = grid.faceAlong(film.face) ? 0 : 1;
    FixedList<scalar, 2> there;
    vector across(Zero);
    for (label k = 0; k < 2; ++k)
    {
        const label samplei = nCorners + (k == 0 ? lower : 1 - lower);
        there[k] = max(gaps[samplei], least);
        setEnd(p, samplei, film, film.ends[k]);
        across += film.ends[k].normals[0] - film.ends[k].normals[1];
    }
    const scalar along =
        1 - sqr(across[film.dir])/max(magSqr(across), VSMALL);
    film.perOpening =
        along*grid.spacing()/(film.gap*(grid.nDims() - 1));

    film.profile = Zero;
    const label n = 16;
    for (label i = 0; i < n; ++i)
    {
        const scalar x = (i + 0.5)/n - 0.5;
        const scalar gap =
            film.gap + (there[1] - there[0])*x
          + 2*(there[0] + there[1] - 2*film.gap)*sqr(x);
        const scalar weight = pow3(film.gap/max(gap, least))/n;
        const FixedList<scalar, 3> a
        ({
            scalar(1), -0.5*(x - sqr(x)), -0.5*(x + sqr(x))
        });
        label place = 0;
        for (label k = 0; k < 3; ++k)
        {
            for (label l = k; l < 3; ++l)
            {
                film.profile[place++] += weight*a[k]*a[l];
            }
        }
    }
    film.resistance = film.profile[0]/sqr(film.gap);
}


void Foam::fsi::filmMeasures::setCut
(
    const label side,
    filmFace& film
) const
{
    const FixedList<point, 4> at(corners.positions(grid.cornersOf(film.face)));
    const edgeCuts linear(moved(side, 0), at, nCorners);
    wallOrigin& origin = film.origins[side];
    origin.cut = linear.n > 0;
    origin.middle = grid.mesh().faceCentres()[film.face];
    scalar error = 0;
    if (origin.cut)
    {
        // Mean over a cut by Simpson's rule
        origin.middle = linear.middle();
        for (label i = 0; i < linear.n; ++i)
        {
            error += from(linear.at[i], side)/linear.n;
        }
        if (nCorners == 4)
        {
            error = (error + 2*from(origin.middle, side))/3;
        }
        const edgeCuts measured(moved(side, error), at, nCorners);
        origin.middle = measured.n > 0 ? measured.middle() : origin.middle;
    }
    film.closed[side] = covered(side, error);
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
