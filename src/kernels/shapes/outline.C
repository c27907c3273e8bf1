// SPDX-License-Identifier: GPL-3.0-or-later

#include "outline.H"
#include "DynamicList.H"
#include "Map.H"
#include "outlineTools.H"

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


//- Square of the distance of the segments a-b and c-d, zero if they meet
static inline scalar distanceSqr
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


//- Box of two points
static inline boundBox segmentBox(const point& a, const point& b)
{
    return boundBox(min(a, b), max(a, b));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::fsi::outline::segmentsNear
(
    const boundBox& box,
    const scalar gap
) const
{
    DynamicList<label> found(points_.size());
    forAll(points_, i)
    {
        if (near(segmentBox(points_[i], points_[next(i)]), box, gap))
        {
            found.append(i);
        }
    }
    return labelList(std::move(found));
}


bool Foam::fsi::outline::nested(const outline& other) const
{
    return
        outlineTools::contains(points_, other.points_[0])
     || outlineTools::contains(other.points_, points_[0]);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::labelList Foam::fsi::outline::loop(const UList<surfaceFace>& segments)
{
    Map<label> next(2*segments.size());
    for (const surfaceFace& segment : segments)
    {
        next.insert(segment[0], segment[1]);
    }

    labelList nodes(segments.size());
    label nodei = segments.first()[0];
    for (label& node : nodes)
    {
        node = nodei;
        nodei = next[nodei];
    }
    return nodes;
}


bool Foam::fsi::outline::near
(
    const boundBox& a,
    const boundBox& b,
    const scalar gap
)
{
    return
        a.min().x() - b.max().x() <= gap && b.min().x() - a.max().x() <= gap
     && a.min().y() - b.max().y() <= gap && b.min().y() - a.max().y() <= gap;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::outline::outline(const pointField& points)
:
    points_(points),
    bounds_(points_, false)
{}


Foam::fsi::outline::outline
(
    const UList<point>& points,
    const UList<surfaceFace>& segments
)
:
    outline(pointField(points, loop(segments)))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::outline Foam::fsi::outline::moved
(
    const tensor& rotation,
    const vector& translation
) const
{
    pointField points(points_.size());
    forAll(points, i)
    {
        points[i] = (rotation & points_[i]) + translation;
    }
    return outline(points);
}


bool Foam::fsi::outline::reaches(const boundBox& box) const
{
    for (const point& p : points_)
    {
        if
        (
            p.x() > box.min().x() && p.x() < box.max().x()
         && p.y() > box.min().y() && p.y() < box.max().y()
        )
        {
            return true;
        }
    }
    return false;
}


bool Foam::fsi::outline::closerThan
(
    const outline& other,
    const scalar gap
) const
{
    if (!near(bounds_, other.bounds_, gap))
    {
        return false;
    }

    const labelList mine = segmentsNear(other.bounds_, gap);
    const labelList others = other.segmentsNear(bounds_, gap);
    const scalar gapSqr = sqr(gap);
    for (const label i : mine)
    {
        const point& a = points_[i];
        const point& b = points_[next(i)];
        const boundBox box = segmentBox(a, b);
        for (const label j : others)
        {
            const point& c = other.points_[j];
            const point& d = other.points_[other.next(j)];
            if (near(box, segmentBox(c, d), gap))
            {
                const scalar sqrDistance = distanceSqr(a, b, c, d);
                if (sqrDistance < gapSqr || sqrDistance == 0)
                {
                    return true;
                }
            }
        }
    }
    return nested(other);
}


Foam::scalar Foam::fsi::outline::distance(const outline& other) const
{
    if (nested(other))
    {
        return 0;
    }

    scalar least = GREAT;
    forAll(points_, i)
    {
        forAll(other.points_, j)
        {
            least = min
            (
                least,
                distanceSqr
                (
                    points_[i],
                    points_[next(i)],
                    other.points_[j],
                    other.points_[other.next(j)]
                )
            );
        }
    }
    return sqrt(least);
}


// ************************************************************************* //
