// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactGeometry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contactGeometry::addTo
(
    nodeGroup& g,
    const surfaceSet& surfaces,
    const label nodei
) const
{
    g.places.add(surfaces.points()[nodei]);
    g.normals.add(nodeNormals_[nodei]);
    g.leastNormalSqr = min(g.leastNormalSqr, magSqr(nodeNormals_[nodei]));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::contactGeometry::nodeGroup Foam::fsi::contactGeometry::group
(
    const surfaceSet& surfaces,
    const label begin,
    const label end
) const
{
    nodeGroup g;
    g.object = surfaces.pointObject()[begin];
    for (label nodei = begin; nodei < end; ++nodei)
    {
        addTo(g, surfaces, nodei);
    }
    return g;
}


Foam::fsi::contactGeometry::nodeGroup Foam::fsi::contactGeometry::group
(
    const surfaceSet& surfaces,
    const label objecti,
    const UList<label>& nodes
) const
{
    nodeGroup g;
    g.object = objecti;
    for (const label local : nodes)
    {
        addTo(g, surfaces, surfaces.pointStart()[objecti] + local);
    }
    return g;
}


bool Foam::fsi::contactGeometry::mayPair
(
    const nodeGroup& nodes,
    const label object,
    const boundBox& places,
    const boundBox& normals,
    const scalar range
) const
{
    const vector apart
    (
        max
        (
            nodes.places.min() - places.max(),
            places.min() - nodes.places.max()
        )
    );
    if (magSqr(max(apart, vector::zero)) > sqr(range))
    {
        return false;
    }
    if (object != nodes.object)
    {
        return true;
    }

    // The most opposed normals, see opposed()
    const vector& a = nodes.normals.min();
    const vector& b = nodes.normals.max();
    const vector& m = normals.min();
    const vector& n = normals.max();
    const scalar along = cmptSum
    (
        min
        (
            min(cmptMultiply(a, m), cmptMultiply(a, n)),
            min(cmptMultiply(b, m), cmptMultiply(b, n))
        )
    );
    return
        selfContact_ && along < 0 && sqr(along) > 0.249*nodes.leastNormalSqr;
}


bool Foam::fsi::contactGeometry::mayPair
(
    const nodeGroup& nodes,
    const label object,
    const label facei,
    const point& centre,
    const scalar reach
) const
{
    const point& lower = nodes.places.min();
    const point& upper = nodes.places.max();
    if (magSqr(centre - max(min(centre, upper), lower)) >= sqr(reach))
    {
        return false;
    }
    if (object != nodes.object)
    {
        return true;
    }

    // The most opposed normal, see opposed(), and how far in front of the
    // face's plane a node is at most, see inFront()
    const vector& n = faceNormals_[facei];
    const vector& a = nodes.normals.min();
    const vector& b = nodes.normals.max();
    const scalar along = cmptSum(min(cmptMultiply(a, n), cmptMultiply(b, n)));
    const scalar front = cmptSum
    (
        max(cmptMultiply(lower - centre, n), cmptMultiply(upper - centre, n))
    );
    return
        selfContact_
     && along < 0 && sqr(along) > 0.249*nodes.leastNormalSqr
     && front > -1e-6*reach;
}


// ************************************************************************* //
