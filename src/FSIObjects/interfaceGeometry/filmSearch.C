// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmSearch.H"
#include "openfoamVersion.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Least cosine between the normals of two surfaces that do not face each other
static const scalar sideways = -0.1;

//- Distance of a point from a wall that has a face [m]
static scalar fromWall
(
    const cartesianMesh& grid,
    const label wallFace,
    const point& p
)
{
    const direction d = grid.faceDirection(wallFace);
    return mag(p[d] - grid.mesh().faceCentres()[wallFace][d]);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmSearch::filmSearch(const cartesianMesh& grid)
:
    besideWall_(grid.mesh().nCells(), false)
{
    for (const polyPatch& patch : grid.mesh().boundaryMesh())
    {
        for (label i = 0; i < patch.size() && isA<wallPolyPatch>(patch); ++i)
        {
            const label facei = patch.start() + i;
            const label celli = patch.faceCells()[i];
            walls_.set(3*celli + grid.faceDirection(facei), facei);
            besideWall_[celli] = true;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmSearch::setSamples
(
    const cartesianMesh& grid,
    const FixedList<const surfaceSamples*, 2>& all,
    const label facei,
    const label here,
    pair& p
)
{
    const label nCorners = grid.nDims() == 2 ? 2 : 4;
    const FixedList<label, 4> corners = grid.cornersOf(facei);
    for (label i = 0; i < nCorners; ++i)
    {
        p.samples[i] = {all[0], corners[i]};
    }
    for (const label at : {here, here + grid.stepAcross(facei)})
    {
        p.samples[nCorners + (at != here)] = {all[1], at};
    }
    p.nSamples = nCorners + 2;
}


Foam::scalar Foam::fsi::filmSearch::choose
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
    if (least >= GREAT)
    {
        return GREAT;
    }
    for (label i = 0; i < p.nSamples; ++i)
    {
        const surfaceSample& s = p.samples[i];
        if
        (
            s.distance() <= 0
         && !isIn(p.objects, surfaces.faceObject()[s.nearestFace()])
        )
        {
            // A third object covers a part of the face
            return GREAT;
        }
    }
    return least;
}


bool Foam::fsi::filmSearch::from
(
    const cartesianMesh& grid,
    const surfaceSet& surfaces,
    const pair& p,
    const label samplei,
    const label side,
    scalar& distance,
    label& face
)
{
    const surfaceSample& s = p.samples[samplei];
    if (p.objects[side] >= 0)
    {
        return s.from(surfaces, p.objects[side], distance, face);
    }
    face = -1;
    distance = fromWall(grid, p.wallFace, s.position());
    return true;
}


bool Foam::fsi::filmSearch::chooseWall
(
    const cartesianMesh& grid,
    const surfaceSet& surfaces,
    const label facei,
    const scalar limit,
    pair& p
) const
{
    bool chosen = false;
    const label owner = grid.mesh().faceOwner()[facei];
    const direction along = grid.faceDirection(facei);
    scalar least = limit;
    for (direction d = 0; d < grid.nDims(); ++d)
    {
        const auto found = walls_.find(3*owner + d);
        if (d == along || found == walls_.end())
        {
            continue;
        }
        const vector outward(grid.mesh().faceAreas()[*found]);
        label object = -1;
        scalar sum = GREAT;
        bool alone = true;
        for (label i = 0; i < p.nSamples && alone; ++i)
        {
            const surfaceSample& s = p.samples[i];
            const label nearest = s.nearestFace();
            const label itsObject =
                nearest < 0 ? -1 : surfaces.faceObject()[nearest];
            alone = nearest >= 0 && (object < 0 || object == itsObject);
            object = itsObject;
            if (!alone)
            {
                break;
            }
            const vector normal(surfaces.areaNormal(nearest));
            if ((normal & outward) > -sideways*mag(normal)*mag(outward))
            {
                sum = min
                (
                    sum,
                    s.distance()
                  + fromWall(grid, *found, s.position())
                );
            }
        }
        if (alone && sum > 0 && sum < least)
        {
            // A surface beyond the wall has no film there
            least = sum;
            chosen = true;
            p.objects[0] = object;
            p.objects[1] = -1;
            p.wallFace = *found;
        }
    }
    return chosen;
}


bool Foam::fsi::filmSearch::isWall
(
    const cartesianMesh& grid,
    const label facei
) const
{
    if (facei < grid.mesh().nInternalFaces())
    {
        return false;
    }
    const label celli = grid.mesh().faceOwner()[facei];
    const auto found = walls_.find(3*celli + grid.faceDirection(facei));
    return found != walls_.end() && *found == facei;
}


// ************************************************************************* //
