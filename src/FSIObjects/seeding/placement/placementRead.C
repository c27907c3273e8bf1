// SPDX-License-Identifier: GPL-3.0-or-later

#include "placement.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Area or volume of a box; 0 if it is none
static scalar sizeOf(const boundBox& box, const direction nDims)
{
    scalar size = 1;
    for (direction d = 0; d < nDims; ++d)
    {
        size *= max(box.span()[d], scalar(0));
    }
    return size;
}


//- Unit of that size
static const char* unitOf(const direction nDims)
{
    return nDims == 2 ? " m2" : " m3";
}


//- Fatal unless the components of a vector that have no meaning in two
//  dimensions are 0, and the others are numbers of this world
static const vector& checkedMotion
(
    const dictionary& dict,
    const word& key,
    const vector& value,
    const vector& outOfPlane
)
{
    const bool planar = cmptMultiply(value, outOfPlane) == vector::zero;
    if (!planar || !(mag(value) < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " but must be a finite vector "
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
    return findShape(dict.get<word>("shape"), space);
}


Foam::label Foam::fsi::placement::findShape
(
    const word& shape,
    const packing& space
) const
{
    const label shapei = space.shapeNames().find(shape);
    if (shapei < 0)
    {
        FatalIOErrorInFunction(dict_)
            << "Unknown shape '" << shape << "' in entry 'shape' of placement "
            << dict_.name() << nl
            << "Valid shapes are " << flatOutput(space.shapeNames())
            << exit(FatalIOError);
    }
    return shapei;
}


Foam::boundBox Foam::fsi::placement::readRegion(const packing& space) const
{
    if (!dict_.found("region"))
    {
        return space.domain();
    }

    const dictionary& region = dict_.subDict("region");
    checkKeys(region, {"min", "max"});
    const boundBox box(region.get<point>("min"), region.get<point>("max"));
    if
    (
        !(sizeOf(box, nDims_) > 0)
     || !closedSurface::near(box, space.domain(), 0, nDims_)
    )
    {
        FatalIOErrorInFunction(region)
            << "The box of entry 'region' in placement " << name_ << " is "
            << box.min() << ' ' << box.max()
            << " but must have min < max and meet the domain "
            << space.domain().min() << ' ' << space.domain().max()
            << exit(FatalIOError);
    }
    return box;
}


Foam::boundBox Foam::fsi::placement::readContainer(const packing& space) const
{
    const boundBox region(readRegion(space));
    vector gap(Zero);
    for (direction d = 0; d < nDims_; ++d)
    {
        gap[d] = wallGap_;
    }
    return boundBox
    (
        max(region.min(), space.domain().min() + gap),
        min(region.max(), space.domain().max() - gap)
    );
}


Foam::word Foam::fsi::placement::fractionKey(const packing& space)
{
    return space.nDims() == 2 ? "areaFraction" : "volumeFraction";
}


Foam::word Foam::fsi::placement::numberKey() const
{
    return
        dict_.found("number") ? "number"
      : nDims_ == 2 ? "areaFraction"
      : "volumeFraction";
}


Foam::label Foam::fsi::placement::readNumber
(
    const packing& space,
    const label shapei
) const
{
    const word fraction(fractionKey(space));
    if (dict_.found("number") == dict_.found(fraction))
    {
        FatalIOErrorInFunction(dict_)
            << "Placement " << name_
            << " needs either the entry 'number' or the entry '"
            << fraction << '\'' << exit(FatalIOError);
    }

    scalar number = 0;
    if (dict_.found("number"))
    {
        number = readAtLeast(dict_, "number", 0, 0);
    }
    else
    {
        const scalar size = sizeOf(readRegion(space), nDims_);
        number =
            readPositive(dict_, fraction)*size/space.shape(shapei).volume()
          + 0.5;
    }
    checkRoom(space, shapei, number, readContainer(space), numberKey());
    return label(number);
}


void Foam::fsi::placement::checkRoom
(
    const packing& space,
    const label shapei,
    const scalar number,
    const boundBox& box,
    const word& key
) const
{
    const scalar own = space.shape(shapei).volume();
    const scalar size = sizeOf(box, nDims_);
    if (number >= 1 && number*own > size*(1 + SMALL))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << key << "' of placement " << name_
            << " asks for " << number << " objects of shape "
            << space.shapeNames()[shapei] << ", " << number*own
            << unitOf(nDims_) << " together, but there is no room for more than"
            << " the " << size << unitOf(nDims_) << " from " << box.min()
            << " to " << box.max() << nl << "Take fewer objects, a smaller"
            << " shape, a larger region or a smaller wallGap (" << wallGap_
            << " m)" << exit(FatalIOError);
    }
}


void Foam::fsi::placement::checkFits
(
    const closedSurface& object,
    const boundBox& container
) const
{
    const vector size(object.bounds().span());
    for (direction d = 0; d < nDims_; ++d)
    {
        if (size[d] > container.span()[d])
        {
            FatalIOErrorInFunction(dict_)
                << "There is no place for an object of placement " << name_
                << ": it is " << size[d] << " m long in direction " << label(d)
                << ", but the "
                << (dict_.found("region") ? "entry 'region'" : "domain")
                << " less wallGap (" << wallGap_ << " m) only "
                << max(container.span()[d], scalar(0)) << " m" << nl
                << "Take a smaller wallGap"
                << (dict_.found("region") ? " or a larger region" : "")
                << exit(FatalIOError);
        }
    }
}


Foam::string Foam::fsi::placement::advice() const
{
    OStringStream os;
    os  << ", a smaller minimumGap (" << minimumGap_
        << " m), a smaller wallGap (" << wallGap_ << " m)"
        << (dict_.found("region") ? " or a larger region" : "");
    return os.str();
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
            << "Placement " << name_ << " puts an object at the centre "
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
        dict.lookupOrDefault("velocity", otherwise),
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
        dict.lookupOrDefault("angularVelocity", otherwise),
        nDims_ == 2 ? vector(1, 1, 0) : vector::zero
    );
}


// ************************************************************************* //
