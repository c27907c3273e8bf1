// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceDistance.H"
#include "triangleProjection.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A square of a distance is less than another if it is less by more than
//  round-off: beside a corner the first of its two faces counts, wherever the
//  object is
static const scalar clearlyLess = 1 - 1e-10;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceDistance::check
(
    const surfaceSet& surfaces,
    const cartesianBlock& block
) const
{
    if (surfaces.nDims() != block.nDims())
    {
        FatalErrorInFunction
            << "Surfaces in " << label(surfaces.nDims())
            << " dimensions on a block in " << label(block.nDims())
            << exit(FatalError);
    }
    forAll(surfaces.points(), nodei)
    {
        if (!std::isfinite(magSqr(surfaces.points()[nodei])))
        {
            FatalErrorInFunction
                << "Node " << nodei << " of object "
                << surfaces.pointObject()[nodei] << " is at "
                << surfaces.points()[nodei]
                << exit(FatalError);
        }
    }
}


bool Foam::fsi::surfaceDistance::isNear
(
    const boundBox& bounds,
    const cartesianBlock& block
) const
{
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        label first, last;
        block.range
        (
            bounds.min()[dir] - bandWidth_,
            bounds.max()[dir] + bandWidth_,
            dir,
            first,
            last
        );
        if (first > last)
        {
            return false;
        }
    }
    return true;
}


template<class Projection>
void Foam::fsi::surfaceDistance::addFace
(
    const Projection& face,
    const label facei,
    const faceReach& reach,
    const cartesianBlock& block
)
{
    // range() takes the samples beside the limits too: these are wide enough
    const scalar h = block.spacing();
    const point lower(reach.bounds().min() + vector::uniform(h));
    const point upper(reach.bounds().max() - vector::uniform(h));
    labelVector first(0, 0, 0), last(0, 0, 0);
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        block.range(lower[dir], upper[dir], dir, first[dir], last[dir]);
    }

    const labelVector& start = block.start();
    for (label k = first.z(); k <= last.z(); ++k)
    {
        for (label j = first.y(); j <= last.y(); ++j)
        {
            point p(block.position(labelVector(0, j, k) - start));
            scalar from, to;
            label begin, end;
            reach.row(p, from, to);
            block.range(from + h, to - h, 0, begin, end);

            const label row =
                block.index(0, j - start.y(), k - start.z()) - start.x();
            for (label i = begin; i <= end; ++i)
            {
                p.x() = block.latticePosition(i, 0);
                const scalar distance = face.distanceSqr(p);
                if (distance < clearlyLess*distance_[row + i])
                {
                    distance_[row + i] = distance;
                    nearestFace_[row + i] = facei;
                }
            }
        }
    }
}


void Foam::fsi::surfaceDistance::addSegments
(
    const surfaceSet& surfaces,
    const label objecti,
    const cartesianBlock& block
)
{
    const labelList& pointStart = surfaces.pointStart();
    const labelList& faceStart = surfaces.faceStart();
    const label firstPoint = pointStart[objecti];

    // Directions of the faces that end and begin at each node
    before_.setSize(pointStart[objecti + 1] - firstPoint);
    after_.setSize(before_.size());
    before_ = Zero;
    after_ = Zero;
    const auto ends = [&](const label facei, point& a, point& b)
    {
        // Distances in the plane, wherever the samples lie in z
        const surfaceFace& f = surfaces.faces()[facei];
        a = surfaces.points()[f[0]];
        b = surfaces.points()[f[1]];
        a.z() = b.z() = block.position(0).z();
    };
    point a, b;
    for (label i = faceStart[objecti]; i < faceStart[objecti + 1]; ++i)
    {
        const surfaceFace& f = surfaces.faces()[i];
        ends(i, a, b);
        const vector along((b - a)/max(mag(b - a), VSMALL));
        after_[f[0] - firstPoint] = along;
        before_[f[1] - firstPoint] = along;
    }
    for (label i = faceStart[objecti]; i < faceStart[objecti + 1]; ++i)
    {
        const surfaceFace& f = surfaces.faces()[i];
        ends(i, a, b);
        const faceReach reach
        (
            a,
            b,
            before_[f[0] - firstPoint],
            after_[f[1] - firstPoint],
            bandWidth_
        );
        addFace(segmentProjection(a, b), i, reach, block);
    }
}


void Foam::fsi::surfaceDistance::addTriangles
(
    const surfaceSet& surfaces,
    const label objecti,
    const cartesianBlock& block
)
{
    const pointField& points = surfaces.points();
    const labelList& faceStart = surfaces.faceStart();

    for (label i = faceStart[objecti]; i < faceStart[objecti + 1]; ++i)
    {
        const surfaceFace& f = surfaces.faces()[i];
        const point& a = points[f[0]];
        const point& b = points[f[1]];
        const point& c = points[f[2]];
        const triangleProjection face(a, b, c);
        const boundBox bounds(min(min(a, b), c), max(max(a, b), c));
        const faceReach reach(bounds, a, face.normal(), bandWidth_);
        addFace(face, i, reach, block);
    }
}


void Foam::fsi::surfaceDistance::finish(const surfaceSet& surfaces)
{
    forAll(distance_, samplei)
    {
        const bool inside = object_[samplei] >= 0;
        scalar distance = bandWidth_;
        if (nearestFace_[samplei] >= 0)
        {
            distance = sqrt(distance_[samplei]);
            object_[samplei] = surfaces.faceObject()[nearestFace_[samplei]];
        }
        distance_[samplei] = inside ? -distance : distance;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceDistance::surfaceDistance(const scalar bandWidth)
:
    bandWidth_(bandWidth)
{
    if (!(bandWidth > 0))
    {
        FatalErrorInFunction
            << "The width of the band is " << bandWidth << " but must be > 0"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::surfaceDistance::update
(
    const surfaceSet& surfaces,
    const cartesianBlock& block
)
{
    check(surfaces, block);

    distance_.setSize(block.size());
    nearestFace_.setSize(block.size());
    object_.setSize(block.size());
    distance_ = sqr(bandWidth_);
    nearestFace_ = -1;
    object_ = -1;

    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (isNear(surfaces.bounds(objecti), block))
        {
            if (surfaces.nDims() == 2)
            {
                addSegments(surfaces, objecti, block);
            }
            else
            {
                addTriangles(surfaces, objecti, block);
            }
            inside_.mark(surfaces, objecti, block, object_);
        }
    }

    finish(surfaces);
}


void Foam::fsi::surfaceDistance::extendVelocity
(
    const surfaceSet& surfaces,
    const cartesianBlock& block,
    vectorField& velocity
) const
{
    velocity.setSize(block.size());
    FixedList<scalar, 3> weights;
    forAll(nearestFace_, samplei)
    {
        velocity[samplei] = Zero;
        if (nearestFace_[samplei] >= 0)
        {
            surfaces.nearestOnFace
            (
                nearestFace_[samplei],
                block.position(samplei),
                weights
            );
            velocity[samplei] = surfaces.interpolate
            (
                surfaces.velocities(),
                nearestFace_[samplei],
                weights
            );
        }
    }
}


// ************************************************************************* //
