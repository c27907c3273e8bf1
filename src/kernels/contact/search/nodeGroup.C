// SPDX-License-Identifier: GPL-3.0-or-later

#include "nodeGroup.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::nodeGroup::mayPair
(
    const label object,
    const boundBox& places,
    const boundBox& normals,
    const scalar range,
    const bool own
) const
{
    const vector apart
    (
        max
        (
            places_.min() - places.max(),
            places.min() - places_.max()
        )
    );
    if (magSqr(max(apart, vector::zero)) > sqr(range))
    {
        return false;
    }
    if (object != object_)
    {
        return true;
    }

    // The most opposed normals, see opposed()
    const vector& a = normals_.min();
    const vector& b = normals_.max();
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
        own && along < 0 && sqr(along) > 0.249*leastNormalSqr_;
}


bool Foam::fsi::nodeGroup::mayPair
(
    const label object,
    const vector& normal,
    const point& centre,
    const scalar reach,
    const bool own
) const
{
    const point& lower = places_.min();
    const point& upper = places_.max();
    if (magSqr(centre - max(min(centre, upper), lower)) >= sqr(reach))
    {
        return false;
    }
    if (object != object_)
    {
        return true;
    }

    // The most opposed normal, see opposed(), and how far in front of the
    // face's plane a node is at most, see inFront()
    const vector& n = normal;
    const vector& a = normals_.min();
    const vector& b = normals_.max();
    const scalar along = cmptSum(min(cmptMultiply(a, n), cmptMultiply(b, n)));
    const scalar front = cmptSum
    (
        max(cmptMultiply(lower - centre, n), cmptMultiply(upper - centre, n))
    );
    return
        own
     && along < 0 && sqr(along) > 0.249*leastNormalSqr_
     && front > -1e-6*reach;
}


// ************************************************************************* //
