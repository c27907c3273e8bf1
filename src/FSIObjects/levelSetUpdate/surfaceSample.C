// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceSample.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::surfaceSamples Foam::fsi::surfaceSamples::centres
(
    const levelSetUpdate& levelSet,
    const cartesianMesh& grid
)
{
    return {levelSet.centreSamples(), levelSet.cellDistance(), grid.cells(1)};
}


Foam::fsi::surfaceSamples Foam::fsi::surfaceSamples::corners
(
    const levelSetUpdate& levelSet,
    const cartesianMesh& grid
)
{
    return
    {
        levelSet.cornerSamples(), levelSet.cornerDistance(), grid.corners()
    };
}


bool Foam::fsi::surfaceSample::from
(
    const surfaceSet& surfaces,
    const label object,
    scalar& distance,
    label& face
) const
{
    const label nearest = nearestFace();
    const label second = secondFace();
    if (nearest >= 0 && surfaces.faceObject()[nearest] == object)
    {
        distance = this->distance();
        face = nearest;
        return true;
    }
    distance = all->of.bandWidth();
    face = -1;
    if (second < 0 || surfaces.faceObject()[second] != object)
    {
        return false;
    }
    const point p(all->block.position(at));
    FixedList<scalar, 3> weights;
    const point there(surfaces.nearestOnFace(second, p, weights));
    if (((p - there) & surfaces.areaNormal(second)) < 0)
    {
        return false;
    }
    distance = secondDistance();
    face = second;
    return true;
}


void Foam::fsi::surfaceSample::towards
(
    const surfaceSet& surfaces,
    const label object,
    scalar& distance,
    label& face
) const
{
    scalar found;
    label itsFace;
    if (from(surfaces, object, found, itsFace))
    {
        distance = found;
        face = itsFace;
    }
}


// ************************************************************************* //
