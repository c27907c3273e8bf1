// SPDX-License-Identifier: GPL-3.0-or-later

#include "closedSurface.H"
#include "DynamicList.H"
#include "nullBox.H"
#include "simplexDistance.H"
#include "surfaceWinding.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The face that reaches farthest along an axis becomes the first one
static void putFirst
(
    labelList& faces,
    const closedSurface& surface,
    const vector& axis
)
{
    scalar most = -GREAT;
    forAll(faces, i)
    {
        const surfaceFace& f = surface.faces()[faces[i]];
        const scalar place =
            axis & (surface.points()[f[0]] + surface.points()[f[1]]);
        if (place > most)
        {
            most = place;
            Swap(faces[0], faces[i]);
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boundBox Foam::fsi::closedSurface::faceBox(const label facei) const
{
    const surfaceFace& f = (*faces_)[facei];
    boundBox box
    (
        min(points_[f[0]], points_[f[1]]),
        max(points_[f[0]], points_[f[1]])
    );
    if (f[2] >= 0)
    {
        extend(box, points_[f[2]]);
    }
    return box;
}


void Foam::fsi::closedSurface::keepNear
(
    labelList& faces,
    boundBox& box,
    const scalar gap
) const
{
    boundBox found(nullBox());
    label n = 0;
    for (const label facei : faces)
    {
        const boundBox own(faceBox(facei));
        if (near(own, box, gap, nDims_))
        {
            faces[n++] = facei;
            extend(found, own);
        }
    }
    faces.resize(n);
    box = found;
}


Foam::scalar Foam::fsi::closedSurface::leastDistanceSqr
(
    const closedSurface& other,
    const scalar limit,
    const bool any
) const
{
    // Only faces in the part that both share can be near
    labelList mine(identityList(faces_->size()));
    labelList others(identityList(other.faces_->size()));
    boundBox box(other.centroid_, other.centroid_);
    keepNear(mine, box, (1 + 1e-9)*(limit + other.outerRadius_));
    other.keepNear(others, box, limit);
    keepNear(mine, box, limit);
    const vector axis(other.centroid_ - centroid_);
    putFirst(mine, *this, axis);
    putFirst(others, other, -axis);

    scalar least = sqr(limit), reach = limit;
    for (const label i : mine)
    {
        const boundBox own(faceBox(i));
        for (const label j : others)
        {
            if (!near(own, other.faceBox(j), reach, nDims_))
            {
                continue;
            }
            const scalar d = simplexDistanceSqr
            (
                points_, (*faces_)[i], other.points_, (*other.faces_)[j]
            );
            if (d < least || d == 0)
            {
                least = d;
                reach = sqrt(d);
                if (any || d == 0)
                {
                    return least;
                }
            }
        }
    }
    return least;
}


bool Foam::fsi::closedSurface::nested(const closedSurface& other) const
{
    return
        (other.inside(bounds_, 0) && contains(other.points_[0]))
     || (inside(other.bounds_, 0) && other.contains(points_[0]));
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::fsi::closedSurface::near
(
    const boundBox& a,
    const boundBox& b,
    const scalar gap,
    const direction nDims
)
{
    scalar apart = 0;
    for (direction d = 0; d < nDims; ++d)
    {
        const scalar between =
            max(a.min()[d] - b.max()[d], b.min()[d] - a.max()[d]);
        apart += sqr(max(between, scalar(0)));
    }
    return apart <= sqr(gap);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::closedSurface::closedSurface
(
    const UList<point>& points,
    const UList<surfaceFace>& faces
)
:
    nDims_(faces.size() && faces[0][2] >= 0 ? 3 : 2),
    points_(points),
    faces_(std::make_shared<const List<surfaceFace>>(faces)),
    bounds_(points_, false)
{
    measure();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::closedSurface Foam::fsi::closedSurface::moved
(
    const tensor& rotation,
    const vector& translation,
    const scalar scale
) const
{
    const tensor turn(scale*rotation);
    closedSurface result;
    result.nDims_ = nDims_;
    result.faces_ = faces_;
    result.volume_ = pow(scale, nDims_)*volume_;
    result.outerRadius_ = scale*outerRadius_;
    result.innerRadius_ = scale*innerRadius_;
    result.centroid_ = (turn & centroid_) + translation;
    result.points_.resize(points_.size());
    forAll(points_, i)
    {
        result.points_[i] = (turn & points_[i]) + translation;
    }
    result.bounds_ = boundBox(result.points_, false);
    return result;
}


bool Foam::fsi::closedSurface::inside
(
    const boundBox& box,
    const scalar gap
) const
{
    scalar least = GREAT;
    for (direction d = 0; d < nDims_; ++d)
    {
        least = min(least, bounds_.min()[d] - box.min()[d]);
        least = min(least, box.max()[d] - bounds_.max()[d]);
    }
    return least >= gap;
}


bool Foam::fsi::closedSurface::contains(const point& p) const
{
    return mag(windingNumber(points_, *faces_, p)) > 0.5;
}


bool Foam::fsi::closedSurface::closerThan
(
    const closedSurface& other,
    const scalar gap
) const
{
    if (!near(bounds_, other.bounds_, gap, nDims_))
    {
        return false;
    }

    const answer known = fromBalls(*this, other, centreDistance(other), gap);
    if (known != UNKNOWN)
    {
        return known == YES;
    }
    const vector axes(solved());
    const vector between(cmptMultiply(axes, other.centroid_ - centroid_));
    const scalar wide = gap + 1e-9*(gap + outerRadius_);
    if (hullsApart(points_, other.points_, axes, between, wide))
    {
        return false;
    }
    const scalar least = leastDistanceSqr(other, max(gap, 1e-30), true);
    return least < sqr(gap) || least == 0 || nested(other);
}


Foam::scalar Foam::fsi::closedSurface::distance
(
    const closedSurface& other,
    const scalar limit
) const
{
    if (!near(bounds_, other.bounds_, limit, nDims_))
    {
        return limit;
    }
    if (nested(other))
    {
        return 0;
    }

    // No more than that of two nodes
    scalar nodesSqr = sqr(limit);
    for (const point& p : points_)
    {
        for (const point& q : other.points_)
        {
            nodesSqr = min(nodesSqr, magSqr(cmptMultiply(solved(), p - q)));
        }
    }
    const scalar reach = (1 + 1e-9)*sqrt(nodesSqr);
    return min(limit, sqrt(leastDistanceSqr(other, reach, false)));
}


// ************************************************************************* //
