// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceSet.H"
#include "triangleProjection.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceSet::surfaceSet(const direction nDims)
:
    nDims_(nDims),
    pointStart_(1, Zero),
    faceStart_(1, Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::surfaceSet::append
(
    const pointField& points,
    const List<surfaceFace>& faces
)
{
    const label objecti = size();
    const label offset = points_.size();

    points_.append(points);
    velocities_.append(vectorField(points.size(), Zero));
    pointObject_.append(labelList(points.size(), objecti));
    pointStart_.append(points_.size());

    label facei = faces_.size();
    faces_.setSize(facei + faces.size());
    for (surfaceFace f : faces)
    {
        for (label& nodei : f)
        {
            nodei = nodei < 0 ? -1 : nodei + offset;
        }
        faces_[facei++] = f;
    }
    faceObject_.append(labelList(faces.size(), objecti));
    faceStart_.append(faces_.size());

    return objecti;
}


void Foam::fsi::surfaceSet::clear()
{
    *this = surfaceSet(nDims_);
}


Foam::point Foam::fsi::surfaceSet::nearestOnFace
(
    const label facei,
    const point& p,
    FixedList<scalar, 3>& weights
) const
{
    const surfaceFace& f = faces_[facei];

    weights =
        nDims_ == 2
      ? segmentProjection(points_[f[0]], points_[f[1]]).weights(p)
      : triangleProjection
        (
            points_[f[0]],
            points_[f[1]],
            points_[f[2]]
        ).weights(p);

    return interpolate(points_, facei, weights);
}


Foam::vector Foam::fsi::surfaceSet::areaNormal(const label facei) const
{
    const surfaceFace& f = faces_[facei];
    const vector u(points_[f[1]] - points_[f[0]]);

    if (nDims_ == 2)
    {
        return vector(u.y(), -u.x(), 0);
    }
    return 0.5*(u ^ (points_[f[2]] - points_[f[0]]));
}


Foam::boundBox Foam::fsi::surfaceSet::bounds(const label objecti) const
{
    const label start = pointStart_[objecti];
    return boundBox
    (
        SubList<point>(points_, pointStart_[objecti + 1] - start, start),
        false
    );
}


Foam::scalar Foam::fsi::surfaceSet::volume(const label objecti) const
{
    // Divergence theorem about a node of the object, for small round-off
    const point& reference = points_[pointStart_[objecti]];
    scalar sum = 0;
    for (label i = faceStart_[objecti]; i < faceStart_[objecti + 1]; ++i)
    {
        sum += areaNormal(i) & (points_[faces_[i][0]] - reference);
    }
    return sum/nDims_;
}


Foam::point Foam::fsi::surfaceSet::centroid(const label objecti) const
{
    // Sum of the simplices spanned by the faces and a node of the object
    const point& reference = points_[pointStart_[objecti]];
    scalar sumVolume = 0;
    vector sumMoment(Zero);
    for (label i = faceStart_[objecti]; i < faceStart_[objecti + 1]; ++i)
    {
        vector sumNodes(Zero);
        for (label nodei = 0; nodei < nNodes(); ++nodei)
        {
            sumNodes += points_[faces_[i][nodei]] - reference;
        }
        const scalar v =
            (areaNormal(i) & (points_[faces_[i][0]] - reference))/nDims_;
        sumVolume += v;
        sumMoment += v*sumNodes/(nDims_ + 1);
    }
    return reference + sumMoment/sumVolume;
}


Foam::scalar Foam::fsi::surfaceSet::surfaceArea(const label objecti) const
{
    scalar sum = 0;
    for (label i = faceStart_[objecti]; i < faceStart_[objecti + 1]; ++i)
    {
        sum += mag(areaNormal(i));
    }
    return sum;
}


// ************************************************************************* //
