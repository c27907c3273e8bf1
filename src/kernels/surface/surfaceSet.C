// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceSet.H"
#include "facesAcross.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceSet::surfaceSet(const direction nDims)
:
    nDims_(nDims),
    pointStart_(1, Zero),
    faceStart_(1, Zero)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::surfaceSet::resize()
{
    points_.resize(pointStart_.last());
    velocities_.resize(pointStart_.last());
    pointObject_.resize(pointStart_.last());
    faces_.resize(faceStart_.last());
    faceObject_.resize(faceStart_.last());
    if (nDims_ == 3)
    {
        facesAcross_.resize(faceStart_.last());
    }
}


void Foam::fsi::surfaceSet::copy
(
    const label from,
    const label to,
    const vector& shift
)
{
    const label offset = pointStart_[to] - pointStart_[from];
    for (label i = pointStart_[to]; i < pointStart_[to + 1]; ++i)
    {
        points_[i] = points_[i - offset] + shift;
        velocities_[i] = velocities_[i - offset];
        pointObject_[i] = to;
    }

    const label faceOffset = faceStart_[to] - faceStart_[from];
    for (label i = faceStart_[to]; i < faceStart_[to + 1]; ++i)
    {
        faces_[i] = faces_[i - faceOffset];
        for (label& nodei : faces_[i])
        {
            nodei = nodei < 0 ? -1 : nodei + offset;
        }
        faceObject_[i] = to;
    }
    for
    (
        label i = faceStart_[to];
        i < faceStart_[to + 1] && nDims_ == 3;
        ++i
    )
    {
        facesAcross_[i] = facesAcross_[i - faceOffset];
        for (label& facei : facesAcross_[i])
        {
            facei = facei < 0 ? -1 : facei + faceOffset;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::surfaceSet::append
(
    const pointField& points,
    const List<surfaceFace>& faces,
    const label number
)
{
    if (original_.size())
    {
        FatalErrorInFunction
            << "Objects cannot be appended behind images"
            << exit(FatalError);
    }

    const label first = size();
    pointStart_.resize(first + number + 1);
    faceStart_.resize(first + number + 1);
    keys_.resize(first + number);
    for (label i = first; i < first + number; ++i)
    {
        keys_[i] = labelPair(i, 0);
        pointStart_[i + 1] = pointStart_[i] + points.size();
        faceStart_[i + 1] = faceStart_[i] + faces.size();
    }
    resize();
    fixed_.resize(first + number, false);
    immersed_.resize(first + number, false);
    if (number == 0)
    {
        return first;
    }

    const label offset = pointStart_[first];
    forAll(points, i)
    {
        points_[offset + i] = points[i];
        velocities_[offset + i] = Zero;
        pointObject_[offset + i] = first;
    }
    label facei = faceStart_[first];
    for (surfaceFace f : faces)
    {
        for (label& nodei : f)
        {
            nodei = nodei < 0 ? -1 : nodei + offset;
        }
        faceObject_[facei] = first;
        faces_[facei++] = f;
    }
    if (nDims_ == 3)
    {
        setFacesAcross(faces_, faceStart_[first], faces.size(), facesAcross_);
    }
    for (label i = first + 1; i < first + number; ++i)
    {
        copy(first, i, Zero);
    }
    return first;
}


void Foam::fsi::surfaceSet::appendImages
(
    const labelUList& originals,
    const UList<vector>& shifts
)
{
    const label first = size();
    pointStart_.resize(first + originals.size() + 1);
    faceStart_.resize(first + originals.size() + 1);
    forAll(originals, i)
    {
        const label objecti = originals[i];
        pointStart_[first + i + 1] =
            pointStart_[first + i]
          + pointStart_[objecti + 1] - pointStart_[objecti];
        faceStart_[first + i + 1] =
            faceStart_[first + i]
          + faceStart_[objecti + 1] - faceStart_[objecti];
    }
    original_.append(originals);

    resize();
    forAll(originals, i)
    {
        copy(original(first + i), first + i, shifts[i]);
    }
}


void Foam::fsi::surfaceSet::clear()
{
    *this = surfaceSet(nDims_);
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
