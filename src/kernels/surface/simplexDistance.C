// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplexDistance.H"
#include "triangleProjection.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Twice the signed area of a triangle in the plane
static inline scalar orient(const point& a, const point& b, const point& c)
{
    return (b.x() - a.x())*(c.y() - a.y()) - (b.y() - a.y())*(c.x() - a.x());
}


//- Square of the distance of a point to the segment a-b in the plane
static inline scalar distanceSqr
(
    const point& p,
    const point& a,
    const point& b
)
{
    const scalar ex = b.x() - a.x(), ey = b.y() - a.y();
    const scalar dx = p.x() - a.x(), dy = p.y() - a.y();
    const scalar along = (dx*ex + dy*ey)/max(ex*ex + ey*ey, VSMALL);
    const scalar t = min(max(along, 0.0), 1.0);
    return sqr(dx - t*ex) + sqr(dy - t*ey);
}


//- Square of the distance of the segments a-b and c-d in the plane
static scalar planeDistanceSqr
(
    const point& a,
    const point& b,
    const point& c,
    const point& d
)
{
    if
    (
        orient(a, b, c)*orient(a, b, d) < 0
     && orient(c, d, a)*orient(c, d, b) < 0
    )
    {
        return 0;
    }
    return min
    (
        min(distanceSqr(a, c, d), distanceSqr(b, c, d)),
        min(distanceSqr(c, a, b), distanceSqr(d, a, b))
    );
}


//- Square of the distance of the segments a-b and c-d in space
static scalar edgeDistanceSqr
(
    const point& a,
    const point& b,
    const point& c,
    const point& d
)
{
    const auto limited = [](const scalar s)
    {
        return min(max(s, scalar(0)), scalar(1));
    };
    const vector u(b - a), v(d - c), w(a - c);
    const scalar uu = max(magSqr(u), VSMALL), vv = max(magSqr(v), VSMALL);
    const scalar uv = u & v, uw = u & w, vw = v & w;

    // The place on a-b nearest to the line c-d, then that on c-d nearest to it,
    // then again on a-b
    const scalar det = uu*vv - uv*uv;
    scalar s = det > SMALL*uu*vv ? limited((uv*vw - vv*uw)/det) : 0;
    const scalar t = limited((uv*s + vw)/vv);
    s = limited((uv*t - uw)/uu);
    return magSqr(w + s*u - t*v);
}


//- Does the segment p-q go through the triangle a, b, c
static bool pierces
(
    const point& p,
    const point& q,
    const point& a,
    const point& b,
    const point& c
)
{
    const vector n((b - a) ^ (c - a));
    if (((p - a) & n)*((q - a) & n) > 0)
    {
        return false;
    }

    // The line from p to q passes all edges on one side
    const vector d(q - p);
    const scalar v[3] =
    {
        d & ((a - p) ^ (b - p)), d & ((b - p) ^ (c - p)),
        d & ((c - p) ^ (a - p))
    };
    return
        (v[0] > 0 && v[1] > 0 && v[2] > 0)
     || (v[0] < 0 && v[1] < 0 && v[2] < 0);
}


//- Square of the distance of two triangles in space
static scalar triangleDistanceSqr(const point (&a)[3], const point (&b)[3])
{
    for (label i = 0; i < 3; ++i)
    {
        const label j = (i + 1) % 3;
        if
        (
            pierces(a[i], a[j], b[0], b[1], b[2])
         || pierces(b[i], b[j], a[0], a[1], a[2])
        )
        {
            return 0;
        }
    }

    const triangleProjection onA(a[0], a[1], a[2]), onB(b[0], b[1], b[2]);
    scalar least = GREAT;
    for (label i = 0; i < 3; ++i)
    {
        least = min(least, min(onB.distanceSqr(a[i]), onA.distanceSqr(b[i])));
        for (label k = 0; k < 3; ++k)
        {
            least = min
            (
                least,
                edgeDistanceSqr(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3])
            );
        }
    }
    return least;
}


//- The point that is farthest along an axis
static const point& farthest(const UList<point>& points, const vector& axis)
{
    label farthesti = 0;
    scalar most = -GREAT;
    forAll(points, i)
    {
        const scalar place = axis & points[i];
        if (place > most)
        {
            most = place;
            farthesti = i;
        }
    }
    return points[farthesti];
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::simplexDistanceSqr
(
    const UList<point>& x,
    const surfaceFace& f,
    const UList<point>& y,
    const surfaceFace& g
)
{
    if (f[2] < 0)
    {
        return planeDistanceSqr(x[f[0]], x[f[1]], y[g[0]], y[g[1]]);
    }
    return triangleDistanceSqr
    (
        {x[f[0]], x[f[1]], x[f[2]]},
        {y[g[0]], y[g[1]], y[g[2]]}
    );
}


bool Foam::fsi::hullsApart
(
    const UList<point>& x,
    const UList<point>& y,
    const vector& solved,
    vector between,
    const scalar gap
)
{
    for (label i = 0; i < 60; ++i)
    {
        const scalar length = mag(between);
        if (length <= gap)
        {
            return false;
        }
        const vector axis(between/length);
        const vector corner
        (
            cmptMultiply(solved, farthest(y, -axis) - farthest(x, axis))
        );
        if ((axis & corner) > gap)
        {
            return true;
        }
        const vector step(corner - between);
        const scalar part = -(between & step)/max(magSqr(step), VSMALL);
        between += min(max(part, scalar(0)), scalar(1))*step;
    }
    return false;
}


// ************************************************************************* //
