// SPDX-License-Identifier: GPL-3.0-or-later

#include "outlineThickness.H"
#include "boundBox.H"
#include "outlineTools.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace outlineThickness
{

//- Turn from which on a place is a corner [rad]
static const scalar cornerAngle = degToRad(15.0);


//- Distance along a unit direction to a side, GREAT if it is not met
static scalar hit
(
    const pointField& polygon,
    const label sidei,
    const point& from,
    const vector& along
)
{
    const vector s = outlineTools::side(polygon, sidei);
    const vector d = polygon[sidei] - from;
    const scalar det = (along ^ s).z();
    if (mag(det) < VSMALL)
    {
        return GREAT;
    }
    const scalar distance = (d ^ s).z()/det;
    const scalar place = (d ^ along).z()/det;
    return distance > 0 && place >= 0 && place <= 1 ? distance : GREAT;
}


//- Distance from the middle of a side to the next one inwards, GREAT unless
//  that one faces it
static scalar widthAtSide(const pointField& polygon, const label i)
{
    const vector s = outlineTools::side(polygon, i);
    const vector inward = vector(-s.y(), s.x(), 0)/mag(s);
    const point middle = polygon[i] + 0.5*s;

    scalar nearest = GREAT;
    label opposite = -1;
    forAll(polygon, j)
    {
        const scalar length =
            j == i ? GREAT : hit(polygon, j, middle, inward);
        if (length < nearest)
        {
            nearest = length;
            opposite = j;
        }
    }
    if (opposite < 0)
    {
        return GREAT;
    }
    const vector t = outlineTools::side(polygon, opposite);
    return
        (s & t) < -std::cos(cornerAngle)*mag(s)*mag(t) ? nearest : GREAT;
}


//- Distance from the tip of a notch to the nearest point of the sides in the
//  sector between the inward normals of its two sides; GREAT if there is none
//  or the polygon does not turn inwards there
static scalar widthAtTip(const pointField& polygon, const label i)
{
    const vector before = outlineTools::side(polygon, polygon.rcIndex(i));
    const vector after = outlineTools::side(polygon, i);
    if (std::atan2((before ^ after).z(), before & after) > -cornerAngle)
    {
        return GREAT;
    }
    scalar nearest = GREAT;
    forAll(polygon, j)
    {
        if (j != i && j != polygon.rcIndex(i))
        {
            const vector s = outlineTools::side(polygon, j);
            const vector d = polygon[j] - polygon[i];
            const scalar place = min(max(-(d & s)/magSqr(s), 0.0), 1.0);
            const vector across = d + place*s;

            // The normals are the sides turned by a right angle
            if ((before & across) >= 0 && (after & across) <= 0)
            {
                nearest = min(nearest, mag(across));
            }
        }
    }
    return nearest;
}

} // End namespace outlineThickness
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::outlineThickness::smallest
(
    const pointField& polygon
)
{
    scalar smallest = GREAT;
    forAll(polygon, i)
    {
        smallest =
            min(smallest, min(widthAtSide(polygon, i), widthAtTip(polygon, i)));
    }

    const vector span = boundBox(polygon, false).span();
    return smallest < GREAT ? smallest : min(span.x(), span.y());
}


// ************************************************************************* //
