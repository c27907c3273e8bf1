// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmFaces.H"
#include "surfaceDistance.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::filmFaces::setCut
(
    const cartesianBlock& corners,
    const label nCorners,
    const FixedList<scalar, 6>& distances,
    const label facei,
    wallOrigin& origin
) const
{
    const FixedList<label, 4> around = grid_.cornersOf(facei);
    point cuts(Zero);
    label nCuts = 0;
    // In 2D there is one edge
    for (label a = 0; a < (nCorners == 2 ? 1 : nCorners); ++a)
    {
        const label b = (a + 1) % nCorners;
        if ((distances[a] > 0) != (distances[b] > 0))
        {
            const scalar part = distances[a]/(distances[a] - distances[b]);
            cuts +=
                (1 - part)*corners.position(around[a])
              + part*corners.position(around[b]);
            ++nCuts;
        }
    }
    origin.cut = nCuts > 0;
    origin.middle =
        origin.cut
      ? point(cuts/nCuts)
      : grid_.mesh().faceCentres()[facei];
}


Foam::point Foam::fsi::filmFaces::openMiddle
(
    const cartesianBlock& corners,
    const label nCorners,
    const FixedList<FixedList<scalar, 6>, 2>& distances,
    const filmFace& film
) const
{
    const FixedList<label, 4> around = grid_.cornersOf(film.face);
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
        // A cut has two ends in 3D
        const scalar weight = origin.cut ? nCorners/2 : 0;
        sum += weight*origin.middle;
        n += weight;
    }
    return n > 0 ? point(sum/n) : grid_.mesh().faceCentres()[film.face];
}


void Foam::fsi::filmFaces::place
(
    const surfaceSet& surfaces,
    const cartesianBlock& corners,
    const filmSearch::pair& p,
    filmFace& film
) const
{
    const label nCorners = p.nSamples - 2;
    FixedList<FixedList<scalar, 6>, 2> distances;
    FixedList<FixedList<label, 6>, 2> faces;
    for (label side = 0; side < 2; ++side)
    {
        for (label i = 0; i < p.nSamples; ++i)
        {
            filmSearch::from
            (
                grid_,
                surfaces,
                p,
                i,
                side,
                distances[side][i],
                faces[side][i]
            );
        }
        film.origins[side].cut = false;
        if (p.objects[side] >= 0)
        {
            setCut
            (
                corners,
                nCorners,
                distances[side],
                film.face,
                film.origins[side]
            );
        }
    }

    const point middle(openMiddle(corners, nCorners, distances, film));
    FixedList<point, 2> at;
    FixedList<scalar, 3> weights;
    for (label side = 0; side < 2; ++side)
    {
        if (p.objects[side] < 0)
        {
            const direction d = grid_.faceDirection(p.wallFace);
            film.sides[side].wallFace = p.wallFace;
            at[side] = middle;
            at[side][d] = grid_.mesh().faceCentres()[p.wallFace][d];
            continue;
        }
        label& face = film.origins[side].surface;
        film.sides[side].place = nearestPlace
        (
            surfaces,
            middle,
            UList<label>(faces[side].data(), p.nSamples),
            face
        );
        at[side] = surfaces.nearestOnFace(face, middle, weights);
    }
    film.gap = max(mag(at[0] - at[1]), thinnest*grid_.spacing());
}


// ************************************************************************* //
