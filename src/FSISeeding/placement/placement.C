// SPDX-License-Identifier: GPL-3.0-or-later

#include "placement.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "rotations.H"

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

Foam::tensor Foam::fsi::placement::randomRotation()
{
    return fsi::randomRotation(random_, nDims_);
}


Foam::vector Foam::fsi::placement::randomInBall()
{
    return fsi::randomInBall(random_, nDims_);
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
            velocityPerturbation_*mag(velocity)*randomInBall();
    }
    return object;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::placement::placement
(
    const word& name,
    const dictionary& dict,
    const packing& space,
    const wordList& ownKeys,
    const scalar defaultMinimumGap,
    const scalar defaultWallGap
)
:
    name_(name),
    dict_(checked(dict, ownKeys)),
    nDims_(space.nDims()),
    velocity_(readVelocity(dict, Zero)),
    angularVelocity_(readAngularVelocity(dict, Zero)),
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
    const word type(readName(dict, "type"));
    const auto* constructor = findIn(*dictionaryConstructorTablePtr_, type);
    if (!constructor)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown type '" << type << "' in entry 'type' of placement "
            << dict.name() << nl << "Valid types are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    return (*constructor)(name, dict, space);
}


// ************************************************************************* //
