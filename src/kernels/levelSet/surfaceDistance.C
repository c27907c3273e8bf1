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
    const boundBox& bounds,
    const cartesianBlock& block
)
{
    // Samples within the band of the face lie in its grown bounding box, and
    // in the slab of the band about its plane; a little wider for round-off
    const scalar width = 1.001*bandWidth_;
    const vector& normal = face.normal();
    const bool steep = mag(normal.x()) > 1e-3;
    const scalar reach = width/max(mag(normal.x()), VSMALL);

    labelVector first(0, 0, 0), last(0, 0, 0);
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        block.range
        (
            bounds.min()[dir] - width,
            bounds.max()[dir] + width,
            dir,
            first[dir],
            last[dir]
        );
    }

    const labelVector& start = block.start();
    for (label k = first.z(); k <= last.z(); ++k)
    {
        for (label j = first.y(); j <= last.y(); ++j)
        {
            point p(block.position(labelVector(0, j, k) - start));
            label begin = first.x();
            label end = last.x();
            if (steep)
            {
                const scalar x = face.planeX(p);
                block.range(x - reach, x + reach, 0, begin, end);
                begin = max(begin, first.x());
                end = min(end, last.x());
            }

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


void Foam::fsi::surfaceDistance::addObject
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
        point a(points[f[0]]);
        point b(points[f[1]]);
        if (surfaces.nDims() == 2)
        {
            // Distances in the plane, wherever the samples lie in z
            a.z() = b.z() = block.position(0).z();
            addFace
            (
                segmentProjection(a, b),
                i,
                boundBox(min(a, b), max(a, b)),
                block
            );
        }
        else
        {
            const point& c = points[f[2]];
            addFace
            (
                triangleProjection(a, b, c),
                i,
                boundBox(min(min(a, b), c), max(max(a, b), c)),
                block
            );
        }
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
            addObject(surfaces, objecti, block);
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
