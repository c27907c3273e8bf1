// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactGeometry.H"
#include "surfaceWinding.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contactGeometry::contactGeometry(const bool selfContact)
:
    selfContact_(selfContact)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::contactGeometry::opposed
(
    const label nodei,
    const label facei
) const
{
    const vector& n = nodeNormals_[nodei];
    const scalar along = n & faceNormals_[facei];
    return along < 0 && sqr(along) > 0.25*magSqr(n);
}


bool Foam::fsi::contactGeometry::inFront
(
    const label nodei,
    const label facei,
    const vector& offset
) const
{
    const vector& n = nodeNormals_[nodei];
    return
        (offset & faceNormals_[facei]) > 0.5*mag(offset)
     && (offset & n) < -0.5*mag(offset)*mag(n);
}


Foam::fsi::contactGeometry::nearestFace
Foam::fsi::contactGeometry::nearestOn
(
    const surfaceSet& surfaces,
    const label facei,
    const point& x
) const
{
    nearestFace nearest;
    nearest.face = facei;
    nearest.offset = x - surfaces.nearestOnFace(facei, x, nearest.weights);
    nearest.normals = faceNormals_[facei];
    return nearest;
}


void Foam::fsi::contactGeometry::keep
(
    const surfaceSet& surfaces,
    const nearestFace& place
)
{
    nearestFace candidate(place);
    const label object = surfaces.faceObject()[place.face];
    const scalar distanceSqr = magSqr(place.offset);
    for (nearestFace& known : nearest_)
    {
        if (surfaces.faceObject()[known.face] == object)
        {
            const scalar knownSqr = magSqr(known.offset);
            if (magSqr(candidate.offset - known.offset) < 1e-18*knownSqr)
            {
                candidate.normals += known.normals;
                known.normals = candidate.normals;
            }
            if (distanceSqr < knownSqr)
            {
                known = candidate;
            }
            return;
        }
    }
    nearest_.append(candidate);
}


Foam::fsi::contactPair Foam::fsi::contactGeometry::pair
(
    const surfaceSet& surfaces,
    const point& x,
    const label own,
    const nearestFace& nearest
) const
{
    const surfaceFace& f = surfaces.faces()[nearest.face];

    vector outward(Zero);
    label nUsed = 0;
    for (label i = 0; i < surfaces.nNodes(); ++i)
    {
        outward += nearest.weights[i]*nodeNormals_[f[i]];
        nUsed += nearest.weights[i] > 1e-9;
    }
    const scalar distance = mag(nearest.offset);
    if (nUsed == surfaces.nNodes() || magSqr(outward) < VSMALL)
    {
        outward = surfaces.areaNormal(nearest.face);
    }
    else if (nUsed == 2)
    {
        outward = nearest.normals;
    }

    contactPair p;
    p.face = nearest.face;
    p.wall = -1;
    p.other = surfaces.faceObject()[nearest.face];
    p.weights = nearest.weights;

    // Pairs within an object face each other (inFront): where the surface is
    // kinked the mean normal may say the opposite, and so does that of a fold
    const bool behind =
        p.other != own
     && (nearest.offset & outward) < 0
     && contains(surfaces, p.other, x);
    const scalar side = behind ? -1 : 1;
    p.gap = side*distance;
    p.normal =
        distance > VSMALL
      ? side*nearest.offset/distance
      : outward/max(mag(outward), VSMALL);
    return p;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactGeometry::update(const surfaceSet& surfaces)
{
    const pointField& x = surfaces.points();
    nodeNormals_.setSize(x.size());
    nodeNormals_ = Zero;
    faceNormals_.setSize(surfaces.faces().size());

    forAll(surfaces.faces(), facei)
    {
        const surfaceFace& f = surfaces.faces()[facei];
        const vector area(surfaces.areaNormal(facei));
        const vector n(area/max(mag(area), VSMALL));
        faceNormals_[facei] = n;

        if (surfaces.nDims() == 2)
        {
            nodeNormals_[f[0]] += n;
            nodeNormals_[f[1]] += n;
            continue;
        }
        for (label i = 0; i < 3; ++i)
        {
            const vector a(x[f[(i + 1) % 3]] - x[f[i]]);
            const vector b(x[f[(i + 2) % 3]] - x[f[i]]);
            nodeNormals_[f[i]] += atan2(mag(a ^ b), a & b)*n;
        }
    }
}


void Foam::fsi::contactGeometry::consider
(
    const surfaceSet& surfaces,
    const label nodei,
    const label facei,
    const scalar range
)
{
    const label object = surfaces.faceObject()[facei];
    const bool own = object == surfaces.pointObject()[nodei];
    if (own && (!selfContact_ || !opposed(nodei, facei)))
    {
        return;
    }

    const nearestFace place
    (
        nearestOn(surfaces, facei, surfaces.points()[nodei])
    );
    if
    (
        magSqr(place.offset) <= sqr(range)
     && (!own || inFront(nodei, facei, place.offset))
    )
    {
        keep(surfaces, place);
    }
}


Foam::scalar Foam::fsi::contactGeometry::reachSqr
(
    const surfaceSet& surfaces,
    const label object,
    const scalar range
) const
{
    for (const nearestFace& known : nearest_)
    {
        if (surfaces.faceObject()[known.face] == object)
        {
            return magSqr(known.offset);
        }
    }
    return sqr(range);
}


void Foam::fsi::contactGeometry::append
(
    const surfaceSet& surfaces,
    const label nodei,
    DynamicList<contactPair>& pairs
)
{
    for (const nearestFace& nearest : nearest_)
    {
        pairs.append
        (
            pair
            (
                surfaces,
                surfaces.points()[nodei],
                surfaces.pointObject()[nodei],
                nearest
            )
        );
        pairs.last().node = nodei;
    }
    nearest_.clear();
}


// ************************************************************************* //
