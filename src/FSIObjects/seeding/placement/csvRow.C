// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvRow.H"
#include "openfoamVersion.H"
#include "rotations.H"

#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::csvRow::csvRow
(
    const wordList& columns,
    const wordList& texts,
    const std::function<void(const string&)>& refuse
)
:
    columns_(columns),
    texts_(texts),
    refuse_(refuse)
{
    if (texts_.size() != columns_.size())
    {
        refuse_
        (
            Foam::name(texts_.size()) + " values, not "
          + Foam::name(columns_.size())
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::csvRow::value
(
    const word& column,
    const scalar otherwise
) const
{
    const label i = indexOf(columns_, column);
    if (i < 0)
    {
        return otherwise;
    }

    // OpenFOAM's readScalar ends in a floating point exception for nan
    std::istringstream is(texts_[i]);
    scalar number = 0;
    if (!(is >> number && is.eof()))
    {
        refuse_("not a number: " + texts_[i]);
    }
    return number;
}


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
    if (isIn(columns_, "axisX"))
    {
        const vector axis(triple("axis", Zero));
        if (!(mag(axis) > VSMALL))
        {
            refuse_("the axis must not be zero");
        }
        return rotationAbout(axis, value("angle", 0));
    }
    if (isIn(columns_, "quaternionW"))
    {
        const scalar w = value("quaternionW", 0);
        const vector v(triple("quaternion", Zero));
        if (!(max(mag(w), mag(v)) > VSMALL))
        {
            refuse_("the quaternion must not be zero");
        }
        return rotationOf(w, v);
    }
    return rotationAboutZ(value("rotation", 0));
}


// ************************************************************************* //
