// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectFeed.H"
#include "feedVelocity.H"
#include "openfoamMesh.H"
#include "readBetween.H"
#include "rotations.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The entry of what the objects fill
static word fractionKey(const direction nDims)
{
    return nDims == 2 ? "areaFraction" : "volumeFraction";
}


//- Box of a patch, of all ranks
static boundBox patchBounds(const polyMesh& mesh, const word& name)
{
    const label patchi = patchOf(mesh.boundaryMesh(), name);
    return boundBox(mesh.boundaryMesh()[patchi].localPoints(), true);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::fsi::objectFeed::checked
(
    const dictionary& dict,
    const direction nDims
)
{
    checkKeys
    (
        dict,
        {
            "shape", "shapes", "rate", fractionKey(nDims), "velocity",
            "angularVelocity", "velocityPerturbation", "randomRotation",
            "rotation", "minimumGap", "sideGap", "seed", "startTime",
            "maxAttempts"
        }
    );
    return dict;
}


void Foam::fsi::objectFeed::check(const dictionary& dict) const
{
    const word fraction(fractionKey(objects_.nDims()));
    if (dict.found("rate") == dict.found(fraction))
    {
        FatalIOErrorInFunction(dict)
            << "Dictionary " << dict.name() << " needs either the entry 'rate'"
            << " or the entry '" << fraction << '\'' << exit(FatalIOError);
    }
    for (label i = 0; i < shapes_.size(); ++i)
    {
        checkFeedVelocity
        (
            dict, velocity_, side_, grid_, objects_.motion(shapes_.group(i)),
            max(nextTime_, grid_.mesh().time().value())
        );
        checkWidth(dict, i);
    }
    if (velocityPerturbation_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'velocityPerturbation' in dictionary " << dict.name()
            << " is " << velocityPerturbation_ << " but must be below 1"
            << exit(FatalIOError);
    }
}


void Foam::fsi::objectFeed::checkWidth
(
    const dictionary& dict,
    const label shapei
) const
{
    // How much wider than the patch in the best of rotations, in two
    // dimensions one degree apart
    const closedSurface& shape = shapes_.surface(shapei);
    randomNumbers random(1);
    scalar least = GREAT;
    for (label degrees = 0; degrees < 180; ++degrees)
    {
        const tensor R
        (
            !randomRotation_ ? rotation_
          : objects_.nDims() == 2 ? rotationAboutZ(degrees)
          : randomRotation(random, 3)
        );
        const vector more
        (
            shape.moved(R, Zero).bounds().span() - bounds_.span()
        );
        scalar largest = -GREAT;
        for (direction d = 0; d < 3; ++d)
        {
            largest = along(d) ? max(largest, more[d]) : largest;
        }
        least = min(least, largest);
    }
    if (least > -2*sideGap_)
    {
        FatalIOErrorInFunction(dict)
            << "An object of shape " << shapes_.name(shapei)
            << " never fits through patch " << patch_ << ", "
            << bounds_.span() << " m: with the entry 'sideGap' " << sideGap_
            << " m on either side it is too wide by " << least + 2*sideGap_
            << " m" << exit(FatalIOError);
    }
}


bool Foam::fsi::objectFeed::due(const scalar time) const
{
    if (interval_ > 0)
    {
        return time >= nextTime_;
    }
    if (time < nextTime_)
    {
        return false;
    }
    // One object more would not exceed the target by more than half of it
    const label nexti = shapes_.group(shapes_.next());
    const scalar own = objects_.shape(nexti).referenceVolume();
    scalar size = 0.5*own;
    forAll(objects_.groups(), groupi)
    {
        size +=
            objects_.nCopies(groupi)
           *objects_.shape(groupi).referenceVolume();
    }
    scalar domain = fraction_;
    for (direction d = 0; d < objects_.nDims(); ++d)
    {
        domain *= grid_.bounds().span()[d];
    }
    return size <= domain;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectFeed::objectFeed
(
    const cartesianMesh& grid,
    const domainSides& sides,
    population& objects,
    const word& patch,
    const dictionary& dict
)
:
    patch_(patch),
    grid_(grid),
    objects_(objects),
    sides_(sides),
    side_(sides.findPatch(patch_)),
    bounds_(patchBounds(grid.mesh(), patch_)),
    shapes_(objects, checked(dict, objects.nDims())),
    interval_(dict.found("rate") ? 1/readPositive(dict, "rate") : 0),
    fraction_(readNonNegative(dict, fractionKey(objects.nDims()), 0)),
    velocity_(readFinite(dict, "velocity")),
    angularVelocity_(readFinite(dict, "angularVelocity", Zero)),
    velocityPerturbation_(readNonNegative(dict, "velocityPerturbation", 0)),
    randomRotation_(dict.lookupOrDefault<Switch>("randomRotation", true)),
    rotation_(readRotation(dict, objects.nDims())),
    minimumGap_(readNonNegative(dict, "minimumGap", 3*grid.spacing())),
    sideGap_(readNonNegative(dict, "sideGap", minimumGap_)),
    seed_(dict.lookupOrDefault<label>("seed", 1)),
    maxAttempts_(readBetween(dict, "maxAttempts", 100, 1, 1000000)),
    nDraws_(0),
    nextTime_(readScalarBetween(dict, "startTime", 0, -GREAT, GREAT)),
    waiting_(false)
{
    check(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::objectFeed::update(const scalar time)
{
    if (!due(time))
    {
        return false;
    }

    randomNumbers random(seed_ + 7919*nDraws_);
    ++nDraws_;
    point centre(Zero);
    tensor rotation(tensor::I);
    const bool found = findPlace(random, centre, rotation);
    if (found == waiting_)
    {
        waiting_ = !found;
        Info<< "Feed at " << patch_ << (found ? " waited" : " waits")
            << " for room, fed " << nFed() << " so far" << endl;
    }
    if (found)
    {
        feed(random, centre, rotation);
        nextTime_ = max(nextTime_ + interval_, time);
    }
    return found;
}


void Foam::fsi::objectFeed::write(Ostream& os) const
{
    putEntry(os, "fed", nFed());
    putEntry(os, "draws", nDraws_);
    putEntry(os, "nextTime", nextTime_);
    putEntry(os, "waiting", Switch(waiting_));
}


void Foam::fsi::objectFeed::read(const dictionary& dict)
{
    checkKeys(dict, {"fed", "draws", "nextTime", "waiting"});
    nDraws_ = getEntry<label>(dict, "draws");
    nextTime_ = getEntry<scalar>(dict, "nextTime");
    waiting_ = getEntry<Switch>(dict, "waiting");
    shapes_.advance(getEntry<label>(dict, "fed"));
}


// ************************************************************************* //
