// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactWall.H"
#include "error.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contactWall::contactWall
(
    const point& p,
    const vector& normal,
    const bool smooth
)
:
    point_(p),
    normal_(normal),
    velocity_(Zero),
    smooth_(smooth)
{
    const scalar length = mag(normal);
    if (!(length > VSMALL && length < GREAT))
    {
        FatalErrorInFunction
            << "Contact wall at " << p << ": the normal " << normal
            << " has no direction" << exit(FatalError);
    }
    normal_ /= length;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactWall::gap(const point& p, vector& away) const
{
    away = normal_;
    if (whole())
    {
        return (p - point_) & normal_;
    }
    scalar least = GREAT;
    for (const boundBox& part : parts_)
    {
        const vector below(part.min() - p);
        const vector above(p - part.max());
        const vector out(max(below, above));
        vector offset(max(out, vector(Zero)));
        scalar gap = mag(offset);
        if (gap <= 0)
        {
            const direction d =
                out.x() > max(out.y(), out.z()) ? 0 : out.y() > out.z() ? 1 : 2;
            gap = out[d];
            offset[d] = 1;
        }
        if (gap < least)
        {
            least = gap;
            for (direction d = 0; d < 3; ++d)
            {
                away[d] = below[d] > above[d] ? -offset[d] : offset[d];
            }
            away /= mag(away);
        }
    }
    return least;
}


// ************************************************************************* //
