// SPDX-License-Identifier: GPL-3.0-or-later

#include "insideFraction.H"

#include <algorithm>
#include <cmath>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::label;

//- Whole numbers to a cell, and a half of the distance of rays
constexpr int64_t perCell = 65536;
constexpr int64_t half = perCell/4;

//- Rays to a cell in y and in z
constexpr int nRays = 2;


//- Number of the first ray at or beyond a place; rays are at (2 i + 1) half
label firstRay(const int64_t place)
{
    // Places are not negative
    return label((place + half - 1)/(2*half));
}


//- Twice the area to the left of a line, > 0 on its left
int64_t leftOf
(
    const int64_t y0, const int64_t z0,
    const int64_t y1, const int64_t z1,
    const int64_t y, const int64_t z
)
{
    return (y1 - y0)*(z - z0) - (z1 - z0)*(y - y0);
}


//- Change of leftOf() from one ray to the next in y
int64_t toNext(const int64_t z0, const int64_t z1)
{
    return (z0 - z1)*(2*half);
}


//- Do the points on an edge belong to the triangle on its left?
bool ownsEdge
(
    const int64_t y0, const int64_t z0,
    const int64_t y1, const int64_t z1
)
{
    return z1 < z0 || (z1 == z0 && y1 > y0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::insideFraction::setBox(const UList<point>& points)
{
    const point& origin = lattice_.origin;
    const scalar perLength = 1/lattice_.spacing;
    vector low(vector::uniform(GREAT)), high(-low);
    for (const point& p : points)
    {
        low = min(low, p);
        high = max(high, p);
    }
    for (direction d = 0; d < 3; ++d)
    {
        const scalar at = std::floor((low[d] - origin[d])*perLength);
        const bool solved = d < lattice_.nDims;
        first_[d] = solved ? label(at) : 0;
        n_[d] =
            solved
          ? label(std::floor((high[d] - origin[d])*perLength) - at) + 2
          : 1;
    }
    for (direction d = 0; d < 3; ++d)
    {
        places_[d].setSize(n_[d]);
        forAll(places_[d], i)
        {
            const label at = lattice_.along(first_[d] + i, d);
            places_[d][i] = at < 0 ? -1 : at*lattice_.stride(d);
        }
    }
    const auto outside = [](const label at) { return at < 0; };
    for (const labelList& along : places_)
    {
        if (std::all_of(along.begin(), along.end(), outside))
        {
            return false;
        }
    }
    parts_.setSize(n_.x()*n_.y()*n_.z());
    parts_ = Zero;
    corners_.setSize(points.size());
    forAll(points, i)
    {
        const vector place((points[i] - origin)*perLength);
        corners_[i].x = place.x() - first_.x();
        // Neither is negative
        corners_[i].y = int64_t(perCell*(place.y() - first_.y()) + 0.5);
        corners_[i].z = int64_t(perCell*(place.z() - first_.z()) + 0.5);
    }
    return true;
}


void Foam::fsi::insideFraction::addTriangle(corner a, corner b, corner c)
{
    int64_t area = leftOf(a.y, a.z, b.y, b.z, c.y, c.z);
    if (area == 0)
    {
        return;
    }
    // Outward along x: the ray leaves
    scalar sign = scalar(-1)/(nRays*nRays);
    if (area < 0)
    {
        std::swap(b, c);
        area = -area;
        sign = -sign;
    }
    const bool ownsAB = ownsEdge(a.y, a.z, b.y, b.z);
    const bool ownsBC = ownsEdge(b.y, b.z, c.y, c.z);
    const bool ownsCA = ownsEdge(c.y, c.z, a.y, a.z);
    const int64_t lowZ = min(a.z, min(b.z, c.z));
    const int64_t highZ = max(a.z, max(b.z, c.z));
    const int64_t lowY = min(a.y, min(b.y, c.y));
    const int64_t highY = max(a.y, max(b.y, c.y));
    for (label k = firstRay(lowZ); (2*k + 1)*half <= highZ; ++k)
    {
        if (places_[2][k/nRays] < 0)
        {
            continue;
        }
        const int64_t z = (2*k + 1)*half;
        label j = firstRay(lowY);
        int64_t y = (2*j + 1)*half;
        int64_t ofC = leftOf(a.y, a.z, b.y, b.z, y, z);
        int64_t ofA = leftOf(b.y, b.z, c.y, c.z, y, z);
        int64_t ofB = leftOf(c.y, c.z, a.y, a.z, y, z);
        for (; y <= highY; ++j, y += 2*half)
        {
            const bool hit =
                (ofC | ofA | ofB) >= 0
             && places_[1][j/nRays] >= 0
             && (ofC > 0 || ownsAB)
             && (ofA > 0 || ownsBC)
             && (ofB > 0 || ownsCA);
            if (hit)
            {
                addRay
                (
                    n_.x()*(j/nRays + n_.y()*(k/nRays)),
                    (ofA*a.x + ofB*b.x + ofC*c.x)/area,
                    sign
                );
            }
            ofC += toNext(a.z, b.z);
            ofA += toNext(b.z, c.z);
            ofB += toNext(c.z, a.z);
        }
    }
}


void Foam::fsi::insideFraction::addSegment(const corner& a, const corner& b)
{
    // Outward along x where y grows: the ray leaves
    const scalar part = (b.y > a.y ? scalar(-1) : scalar(1))/nRays;
    const int64_t low = min(a.y, b.y), high = max(a.y, b.y);
    for (label j = firstRay(low); (2*j + 1)*half < high; ++j)
    {
        const scalar t = scalar((2*j + 1)*half - a.y)/scalar(b.y - a.y);
        if (places_[1][j/nRays] >= 0)
        {
            addRay(n_.x()*(j/nRays), a.x + t*(b.x - a.x), part);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::insideFraction::add
(
    const UList<point>& points,
    const UList<surfaceFace>& faces,
    const scalar value,
    scalarField& fraction,
    scalarField& values
)
{
    if (!setBox(points))
    {
        return;
    }
    for (const surfaceFace& f : faces)
    {
        if (f[2] < 0)
        {
            addSegment(corners_[f[0]], corners_[f[1]]);
        }
        else
        {
            addTriangle(corners_[f[0]], corners_[f[1]], corners_[f[2]]);
        }
    }
    labelVector ijk;
    for (ijk.z() = 0; ijk.z() < n_.z(); ++ijk.z())
    {
        for (ijk.y() = 0; ijk.y() < n_.y(); ++ijk.y())
        {
            const label y = places_[1][ijk.y()], z = places_[2][ijk.z()];
            if (y < 0 || z < 0)
            {
                continue;
            }
            const label row = n_.x()*(ijk.y() + n_.y()*ijk.z());
            scalar sum = 0;
            for (ijk.x() = 0; ijk.x() < n_.x(); ++ijk.x())
            {
                sum += parts_[row + ijk.x()];
                const label x = places_[0][ijk.x()];
                if (x >= 0 && mag(sum) > 1e-12)
                {
                    fraction[x + y + z] += sum;
                    values[x + y + z] += value*sum;
                }
            }
        }
    }
}


// ************************************************************************* //
