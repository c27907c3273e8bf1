// SPDX-License-Identifier: GPL-3.0-or-later

#include "outlineTools.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace outlineTools
{

//- z component of the cross product
static scalar cross(const vector& a, const vector& b)
{
    return a.x()*b.y() - a.y()*b.x();
}


//- Labels of the corners
static labelList corners(const pointField& polygon, const scalar angle)
{
    DynamicList<label> found;
    forAll(polygon, i)
    {
        const vector before = side(polygon, polygon.rcIndex(i));
        const vector after = side(polygon, i);
        const scalar turn =
            std::atan2(mag(cross(before, after)), before & after);
        if (turn > angle)
        {
            found.append(i);
        }
    }
    return labelList(std::move(found));
}


//- Append the start and inner points of a section divided evenly
static void divide
(
    const pointField& polygon,
    const label start,
    const label nSides,
    const label nParts,
    DynamicList<point>& points
)
{
    const label n = polygon.size();

    scalarField length(nSides + 1, 0.0);
    for (label i = 0; i < nSides; ++i)
    {
        length[i + 1] = length[i] + mag(side(polygon, (start + i) % n));
    }

    label i = 0;
    for (label part = 0; part < nParts; ++part)
    {
        const scalar target = length[nSides]*part/nParts;
        while (i + 1 < nSides && length[i + 1] <= target)
        {
            ++i;
        }
        const label from = (start + i) % n;
        const scalar fraction =
            (target - length[i])/max(length[i + 1] - length[i], VSMALL);
        points.append(polygon[from] + fraction*side(polygon, from));
    }
}

} // End namespace outlineTools
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::outlineTools::area(const pointField& polygon)
{
    scalar twice = 0;
    forAll(polygon, i)
    {
        twice += cross
        (
            polygon[i] - polygon[0],
            polygon[polygon.fcIndex(i)] - polygon[0]
        );
    }
    return 0.5*twice;
}


Foam::point Foam::fsi::outlineTools::centroid(const pointField& polygon)
{
    vector sum(Zero);
    forAll(polygon, i)
    {
        const vector a = polygon[i] - polygon[0];
        const vector b = polygon[polygon.fcIndex(i)] - polygon[0];
        sum += cross(a, b)*(a + b);
    }
    return polygon[0] + sum/(6*area(polygon));
}


Foam::scalar Foam::fsi::outlineTools::perimeter(const pointField& polygon)
{
    scalar length = 0;
    forAll(polygon, i)
    {
        length += mag(side(polygon, i));
    }
    return length;
}


Foam::pointField Foam::fsi::outlineTools::counterClockwise
(
    const pointField& polygon
)
{
    pointField turned(polygon);
    if (area(polygon) < 0)
    {
        reverse(turned);
    }
    return turned;
}


bool Foam::fsi::outlineTools::contains
(
    const pointField& polygon,
    const point& p
)
{
    // Parity of the sides to the right of the point
    bool inside = false;
    forAll(polygon, i)
    {
        const point& a = polygon[i];
        const point& b = polygon[polygon.fcIndex(i)];
        if ((a.y() > p.y()) != (b.y() > p.y()))
        {
            const scalar x =
                a.x() + (p.y() - a.y())*(b.x() - a.x())/(b.y() - a.y());
            inside = (x > p.x()) != inside;
        }
    }
    return inside;
}


Foam::scalar Foam::fsi::outlineTools::distance
(
    const pointField& polygon,
    const point& p
)
{
    scalar smallest = GREAT;
    forAll(polygon, i)
    {
        const vector s = side(polygon, i);
        const vector d = p - polygon[i];
        const scalar place =
            min(max((d & s)/max(magSqr(s), VSMALL), scalar(0)), scalar(1));
        smallest = min(smallest, magSqr(d - place*s));
    }
    return std::sqrt(smallest);
}


Foam::pointField Foam::fsi::outlineTools::resample
(
    const pointField& polygon,
    const scalar spacing,
    const scalar cornerAngle
)
{
    const labelList cornerLabels(corners(polygon, cornerAngle));
    DynamicList<point> points;

    if (cornerLabels.empty())
    {
        const label nParts =
            max(label(3), label(std::lround(perimeter(polygon)/spacing)));
        divide(polygon, 0, polygon.size(), nParts, points);
        return pointField(std::move(points));
    }

    forAll(cornerLabels, i)
    {
        const label start = cornerLabels[i];
        const label end = cornerLabels[cornerLabels.fcIndex(i)];
        const label nSides =
            end > start ? end - start : end - start + polygon.size();

        scalar length = 0;
        for (label j = 0; j < nSides; ++j)
        {
            length += mag(side(polygon, (start + j) % polygon.size()));
        }
        const label least = cornerLabels.size() < 3 ? 3 : 1;
        const label nParts = max(least, label(std::lround(length/spacing)));
        divide(polygon, start, nSides, nParts, points);
    }
    return pointField(std::move(points));
}


// ************************************************************************* //
