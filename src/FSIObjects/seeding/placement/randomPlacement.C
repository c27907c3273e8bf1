// SPDX-License-Identifier: GPL-3.0-or-later

#include "randomPlacement.H"
#include "Switch.H"
#include "addToRunTimeSelectionTable.H"
#include "readBetween.H"
#include "rotations.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(randomPlacement, 0);
    addToRunTimeSelectionTable(placement, randomPlacement, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::randomPlacement::findPlace
(
    const packing& space,
    const boundBox& container,
    placedObject& object,
    label& nConflicts
)
{
    nConflicts = 0;
    const vector span = container.span();
    for (label i = 0; i < maxAttempts_; ++i)
    {
        object.centre = container.min();
        for (direction d = 0; d < nDims(); ++d)
        {
            object.centre[d] += span[d]*random().sample01<scalar>();
        }
        object.rotation = randomRotation_ ? randomRotation() : rotation_;

        const closedSurface candidate = space.placed(object);
        if (candidate.inside(container, 0))
        {
            if (space.findConflict(candidate, minimumGap()) < 0)
            {
                return true;
            }
            ++nConflicts;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::randomPlacement::randomPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    placement
    (
        name,
        dict,
        space,
        {
            "region", "number", fractionKey(space), "rotation",
            "randomRotation", "maxAttempts"
        },
        3*space.spacing(),
        dict.lookupOrDefault<scalar>("minimumGap", 3*space.spacing())
    ),
    shape_(readShape(dict, space)),
    randomRotation_(dict.lookupOrDefault<Switch>("randomRotation", true)),
    rotation_(readRotation(dict, nDims())),
    maxAttempts_(readBetween(dict, "maxAttempts", 10000, 1, 10000000))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::randomPlacement::place(packing& space)
{
    const boundBox container(readContainer(space));
    const label number = readNumber(space, shape_);

    for (label i = 0; i < number; ++i)
    {
        placedObject object = newObject(shape_, container.min(), tensor::I);
        label nConflicts = 0;
        if (!findPlace(space, container, object, nConflicts))
        {
            if (nConflicts == 0)
            {
                // None of the places was in the container
                const closedSurface& s = space.shape(shape_);
                checkFits
                (
                    randomRotation_ ? space.placed(object)
                  : s.moved(rotation_, Zero),
                    container
                );
            }
            FatalIOErrorInFunction(dict())
                << "Entry '" << numberKey() << "' of placement " << name()
                << " asks for " << number << " objects of shape "
                << space.shapeNames()[shape_]
                << " but there is no room for more than " << i
                << " found in " << maxAttempts_ << " attempts (maxAttempts): "
                << nConflicts << " were too near to other objects, "
                << maxAttempts_ - nConflicts << " to the walls or the ends of"
                << " the region" << nl << "Take fewer objects"
                << advice().c_str() << ", or type packed"
                << exit(FatalIOError);
        }
        space.insert(object);
    }
}


// ************************************************************************* //
