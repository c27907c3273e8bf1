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


// ************************************************************************* //
