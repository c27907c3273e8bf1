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


// ************************************************************************* //
