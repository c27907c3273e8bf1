// SPDX-License-Identifier: GPL-3.0-or-later

#include "placement.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "readBetween.H"
#include "shapeParts.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Fatal unless the components of a vector that have no meaning in two
//  dimensions are 0
static const vector& checkedMotion
(
    const dictionary& dict,
    const word& key,
    const vector& value,
    const vector& outOfPlane
)
{
    if (cmptMultiply(value, outOfPlane) != vector::zero)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " but must be a vector "
            << (outOfPlane.z() > 0 ? "(vx vy 0)" : "(0 0 w)")
            << " in two dimensions, any in three" << exit(FatalIOError);
    }
    return value;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::label Foam::fsi::placement::readShape
(
    const dictionary& dict,
    const packing& space
) const
{
    return findShape(getEntry<word>(dict, "shape"), space);
}


Foam::label Foam::fsi::placement::findShape
(
    const word& shape,
    const packing& space
) const
{
    const label shapei = indexOf(space.shapeNames(), shape);
    if (shapei < 0)
    {
        shapeParts::fail(dict_, "shape", shape, space.shapeNames());
    }
    return shapei;
}


Foam::point Foam::fsi::placement::checkedCentre
(
    const point& centre,
    const packing& space
) const
{
    const scalar z = centre.z();
    const boundBox& domain = space.domain();
    if
    (
        nDims_ == 2 && z != 0
     && !(z >= domain.min().z() && z <= domain.max().z())
    )
    {
        FatalIOErrorInFunction(dict_)
            << "An object of placement " << name_ << " has the centre "
            << centre << ", out of the plane: in two dimensions z must be 0 or"
            << " lie in the mesh, from " << domain.min().z() << " to "
            << domain.max().z() << " m" << exit(FatalIOError);
    }
    return centre;
}


Foam::vector Foam::fsi::placement::readVelocity
(
    const dictionary& dict,
    const vector& otherwise
) const
{
    return checkedMotion
    (
        dict,
        "velocity",
        readFinite(dict, "velocity", otherwise),
        vector(0, 0, nDims_ == 2)
    );
}


Foam::vector Foam::fsi::placement::readAngularVelocity
(
    const dictionary& dict,
    const vector& otherwise
) const
{
    return checkedMotion
    (
        dict,
        "angularVelocity",
        readFinite(dict, "angularVelocity", otherwise),
        nDims_ == 2 ? vector(1, 1, 0) : vector::zero
    );
}


// ************************************************************************* //
