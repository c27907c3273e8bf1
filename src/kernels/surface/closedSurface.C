// SPDX-License-Identifier: GPL-3.0-or-later

#include "closedSurface.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "Map.H"
#include "simplexDistance.H"
#include "surfaceWinding.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::closedSurface::measure()
{
    surfaceSet alone(nDims_);
    alone.append(points_, *faces_);
    volume_ = alone.volume(0);
    centroid_ = alone.centroid(0);

    for (const point& p : points_)
    {
        outerRadius_ = max(outerRadius_, mag(p - centroid_));
    }
    if (contains(centroid_))
    {
        innerRadius_ = outerRadius_;
        FixedList<scalar, 3> weights;
        forAll(*faces_, facei)
        {
            const point nearest =
                alone.nearestOnFace(facei, centroid_, weights);
            innerRadius_ = min(innerRadius_, mag(nearest - centroid_));
        }
    }
}


Foam::scalar Foam::fsi::closedSurface::centreDistance
(
    const closedSurface& other
) const
{
    vector d(other.centroid_ - centroid_);
    if (nDims_ == 2)
    {
        d.z() = 0;
    }
    return mag(d);
}


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
        box.add(points_[f[2]]);
    }
    return box;
}


Foam::labelList Foam::fsi::closedSurface::facesNear
(
    const labelList& faces,
    const boundBox& box,
    const scalar gap
) const
{
    DynamicList<label> found(faces.size());
    for (const label facei : faces)
    {
        if (near(faceBox(facei), box, gap, nDims_))
        {
            found.append(facei);
        }
    }
    return labelList(std::move(found));
}


Foam::boundBox Foam::fsi::closedSurface::boxOf(const labelList& faces) const
{
    boundBox box;
    for (const label facei : faces)
    {
        box.add(faceBox(facei));
    }
    return box;
}


bool Foam::fsi::closedSurface::nested(const closedSurface& other) const
{
    return contains(other.points_[0]) || other.contains(points_[0]);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::labelList Foam::fsi::closedSurface::loop
(
    const UList<surfaceFace>& segments
)
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


bool Foam::fsi::closedSurface::near
(
    const boundBox& a,
    const boundBox& b,
    const scalar gap,
    const direction nDims
)
{
    for (direction d = 0; d < nDims; ++d)
    {
        if
        (
            a.min()[d] - b.max()[d] > gap
         || b.min()[d] - a.max()[d] > gap
        )
        {
            return false;
        }
    }
    return true;
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
    const vector& translation
) const
{
    closedSurface result;
    result.nDims_ = nDims_;
    result.faces_ = faces_;
    result.volume_ = volume_;
    result.outerRadius_ = outerRadius_;
    result.innerRadius_ = innerRadius_;
    result.centroid_ = (rotation & centroid_) + translation;
    result.points_.resize(points_.size());
    forAll(points_, i)
    {
        result.points_[i] = (rotation & points_[i]) + translation;
    }
    result.bounds_ = boundBox(result.points_, false);
    return result;
}


bool Foam::fsi::closedSurface::reaches(const boundBox& box) const
{
    for (const point& p : points_)
    {
        bool within = true;
        for (direction d = 0; d < nDims_; ++d)
        {
            within = within && p[d] > box.min()[d] && p[d] < box.max()[d];
        }
        if (within)
        {
            return true;
        }
    }
    return false;
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

    // More than round-off, so that what follows decides when it is close
    const scalar slack = 1e-9;
    const scalar apart = centreDistance(other);
    if (apart > (1 + slack)*(outerRadius_ + other.outerRadius_ + gap))
    {
        return false;
    }
    if
    (
        min(innerRadius_, other.innerRadius_) > 0
     && apart < (1 - slack)*(innerRadius_ + other.innerRadius_ + gap)
    )
    {
        return true;
    }

    // Only faces in the part that both share can be near
    labelList mine(identity(faces_->size()));
    labelList others(identity(other.faces_->size()));
    mine = facesNear(mine, other.bounds_, gap);
    others = other.facesNear(others, boxOf(mine), gap);
    mine = facesNear(mine, other.boxOf(others), gap);

    const scalar gapSqr = sqr(gap);
    for (const label i : mine)
    {
        const boundBox box(faceBox(i));
        for (const label j : others)
        {
            if (near(box, other.faceBox(j), gap, nDims_))
            {
                const scalar d = simplexDistanceSqr
                (
                    points_, (*faces_)[i], other.points_, (*other.faces_)[j]
                );
                if (d < gapSqr || d == 0)
                {
                    return true;
                }
            }
        }
    }
    return nested(other);
}


Foam::scalar Foam::fsi::closedSurface::distance
(
    const closedSurface& other
) const
{
    if (nested(other))
    {
        return 0;
    }

    scalar least = GREAT, leastSqr = GREAT;
    forAll(*faces_, i)
    {
        const boundBox box(faceBox(i));
        if (!near(box, other.bounds_, least, nDims_))
        {
            continue;
        }
        forAll(*other.faces_, j)
        {
            if (near(box, other.faceBox(j), least, nDims_))
            {
                const scalar d = simplexDistanceSqr
                (
                    points_, (*faces_)[i], other.points_, (*other.faces_)[j]
                );
                leastSqr = min(leastSqr, d);
                least = sqrt(leastSqr);
            }
        }
    }
    return least;
}


// ************************************************************************* //
