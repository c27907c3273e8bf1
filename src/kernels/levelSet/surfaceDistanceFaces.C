// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceDistance.H"
#include "segmentReach.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceDistance::addSegment
(
    const segmentProjection& face,
    const label facei,
    const segmentReach& reach,
    const cartesianBlock& block
)
{
    const label first = block.nUpTo(reach.bounds().min().y(), 1);
    const label end = block.nUpTo(reach.bounds().max().y(), 1);
    for (label j = first; j < end; ++j)
    {
        point p(block.position(labelVector(0, j, 0)));
        scalar from, to;
        reach.row(p, from, to);
        const label begin = block.nUpTo(from, 0);
        const label behind = block.nUpTo(to, 0);
        const label row = block.index(0, j, 0);
        for (label i = begin; i < behind; ++i)
        {
            p.x() = block.latticePosition(block.start().x() + i, 0);
            near_.take(row + i, facei, face.distanceSqr(p));
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
    const label firstNode = surfaces.pointStart()[objecti];
    const label firstFace = surfaces.faceStart()[objecti];
    const label nFaces = surfaces.faceStart()[objecti + 1] - firstFace;

    endsAt_.setSize(surfaces.pointStart()[objecti + 1] - firstNode);
    beginsAt_.setSize(endsAt_.size());
    endsAt_ = -1;
    beginsAt_ = -1;
    along_.setSize(nFaces);
    length_.setSize(nFaces);
    const auto ends = [&](const label i, point& a, point& b)
    {
        // Distances in the plane, wherever the samples lie in z
        const surfaceFace& f = surfaces.faces()[firstFace + i];
        a = surfaces.points()[f[0]];
        b = surfaces.points()[f[1]];
        a.z() = b.z() = block.position(0).z();
    };
    point a, b;
    for (label i = 0; i < nFaces; ++i)
    {
        const surfaceFace& f = surfaces.faces()[firstFace + i];
        ends(i, a, b);
        length_[i] = mag(b - a);
        along_[i] = (1/max(length_[i], VSMALL))*(b - a);
        beginsAt_[f[0] - firstNode] = i;
        endsAt_[f[1] - firstNode] = i;
    }

    // The first one of the two faces at a node has the samples beyond both
    const auto turn = [&](const label i, const label other)
    {
        return
            other < 0 ? 1
          : other < i ? 0
          : segmentReach::turn(along_[i], along_[other]);
    };
    // Samples outside the object's box are not reset
    const boundBox box(reach(surfaces, objecti));
    for (label i = 0; i < nFaces; ++i)
    {
        const surfaceFace& f = surfaces.faces()[firstFace + i];
        ends(i, a, b);
        segmentReach around
        (
            a,
            along_[i],
            length_[i],
            turn(i, endsAt_[f[0] - firstNode]),
            turn(i, beginsAt_[f[1] - firstNode]),
            bandWidth_
        );
        around.clip(box);
        addSegment(segmentProjection(a, b), firstFace + i, around, block);
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

    cones_.update(surfaces, objecti);
    for (label i = faceStart[objecti]; i < faceStart[objecti + 1]; ++i)
    {
        const surfaceFace& f = surfaces.faces()[i];
        samples_.update
        (
            triangleReach(surfaces, i, cones_, bandWidth_),
            triangleProjection(points[f[0]], points[f[1]], points[f[2]]),
            block
        );
        for (label k = 0; k < samples_.size(); ++k)
        {
            near_.take(samples_.index(k), i, samples_.distanceSqr(k));
        }
    }
}


// ************************************************************************* //
