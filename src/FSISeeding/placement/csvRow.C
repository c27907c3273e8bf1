// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvRow.H"
#include "rotations.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::csvRow::triple
(
    const word& name,
    const vector& otherwise
) const
{
    return vector
    (
        value(name + 'X', otherwise.x()),
        value(name + 'Y', otherwise.y()),
        value(name + 'Z', otherwise.z())
    );
}


Foam::tensor Foam::fsi::csvRow::rotation() const
{
    if (has("axisX"))
    {
        const vector axis(triple("axis", Zero));
        if (!(mag(axis) > 1e-50))
        {
            refuse("axisX", "the axis must not be zero");
        }
        return rotationAbout(axis, value("angle", 0));
    }
    if (has("quaternionW"))
    {
        const scalar w = value("quaternionW", 0);
        const vector v(triple("quaternion", Zero));
        if (!(max(mag(w), mag(v)) > 1e-50))
        {
            refuse("quaternionW", "the quaternion must not be zero");
        }
        return rotationOf(w, v);
    }
    if (has("eulerX"))
    {
        return rotationXYZ(triple("euler", Zero));
    }
    return rotationAboutZ(value("rotation", 0));
}


// ************************************************************************* //
