// SPDX-License-Identifier: GPL-3.0-or-later

#include "placement.H"
#include "dictionaryCheck.H"
#include "outlineTools.H"
#include "randomInPlane.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(placement, 0);
    defineRunTimeSelectionTable(placement, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The keys of all placements and some more
static wordList withCommonKeys(const wordList& ownKeys)
{
    wordList keys
    ({
        "type", "shape", "velocity", "angularVelocity", "velocityPerturbation",
        "minimumGap", "wallGap", "seed"
    });
    keys.append(ownKeys);
    return keys;
}


//- The dictionary, after its keys are checked
static const dictionary& checked
(
    const dictionary& dict,
    const wordList& ownKeys
)
{
    checkKeys(dict, withCommonKeys(ownKeys));
    return dict;
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
        !(box.min().x() < box.max().x() && box.min().y() < box.max().y())
     || !outline::near(box, space.domain(), 0)
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
    const vector gap(wallGap_, wallGap_, 0);
    return boundBox
    (
        max(region.min(), space.domain().min() + gap),
        min(region.max(), space.domain().max() - gap)
    );
}


Foam::label Foam::fsi::placement::readNumber
(
    const packing& space,
    const label shapei
) const
{
    if (dict_.found("number") == dict_.found("areaFraction"))
    {
        FatalIOErrorInFunction(dict_)
            << "Placement " << name_
            << " needs either the entry 'number' or the entry 'areaFraction'"
            << exit(FatalIOError);
    }

    if (dict_.found("number"))
    {
        const label number = dict_.get<label>("number");
        if (number < 0)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'number' in placement " << name_ << " is " << number
                << " but must be >= 0" << exit(FatalIOError);
        }
        return number;
    }

    const vector span = readRegion(space).span();
    const scalar fraction = readPositive(dict_, "areaFraction");
    const scalar area = outlineTools::area(space.shape(shapei).points());
    return label(fraction*span.x()*span.y()/area + 0.5);
}


Foam::tensor Foam::fsi::placement::rotation(const scalar degrees)
{
    return rotationAboutZ(degrees);
}


Foam::tensor Foam::fsi::placement::randomRotation()
{
    return rotation(360*random_.sample01<scalar>());
}


Foam::vector Foam::fsi::placement::randomInDisc()
{
    return fsi::randomInDisc(random_);
}


Foam::fsi::placedObject Foam::fsi::placement::newObject
(
    const label shapei,
    const point& centre,
    const tensor& rotation
)
{
    return newObject(shapei, centre, rotation, velocity_, angularVelocity_);
}


Foam::fsi::placedObject Foam::fsi::placement::newObject
(
    const label shapei,
    const point& centre,
    const tensor& rotation,
    const vector& velocity,
    const vector& angularVelocity
)
{
    placedObject object;
    object.shape = shapei;
    object.centre = centre;
    object.rotation = rotation;
    object.velocity = velocity;
    object.angularVelocity = angularVelocity;
    object.placement = name_;
    if (velocityPerturbation_ > 0)
    {
        if (magSqr(velocity) == 0)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'velocityPerturbation' of placement " << name_
                << " is relative to the velocity, but the velocity of an"
                << " object is zero (entry 'velocity')" << exit(FatalIOError);
        }
        object.velocity +=
            velocityPerturbation_*mag(velocity)*randomInDisc();
    }
    return object;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::placement::placement
(
    const word& name,
    const dictionary& dict,
    const wordList& ownKeys,
    const scalar defaultMinimumGap,
    const scalar defaultWallGap
)
:
    name_(name),
    dict_(checked(dict, ownKeys)),
    velocity_(dict.lookupOrDefault<vector>("velocity", Zero)),
    angularVelocity_(dict.lookupOrDefault<vector>("angularVelocity", Zero)),
    velocityPerturbation_(readNonNegative(dict, "velocityPerturbation", 0)),
    minimumGap_(readNonNegative(dict, "minimumGap", defaultMinimumGap)),
    wallGap_(readNonNegative(dict, "wallGap", defaultWallGap)),
    random_(dict.lookupOrDefault<label>("seed", 1))
{}


Foam::autoPtr<Foam::fsi::placement> Foam::fsi::placement::New
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
{
    const word type(dict.get<word>("type"));
    auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown type '" << type << "' in entry 'type' of placement "
            << dict.name() << nl << "Valid types are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    return constructor()(name, dict, space);
}


// ************************************************************************* //
