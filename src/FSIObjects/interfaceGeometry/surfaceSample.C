// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceSample.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    distance = of->bandWidth();
    face = -1;
    if (second >= 0 && surfaces.faceObject()[second] == object)
    {
        // It is outside of this one, inside at most of the nearest
        distance = secondDistance();
        face = second;
        return true;
    }
    return false;
}


// ************************************************************************* //
