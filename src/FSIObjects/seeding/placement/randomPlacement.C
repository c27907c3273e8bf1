// SPDX-License-Identifier: GPL-3.0-or-later

#include "randomPlacement.H"
#include "Switch.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

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
    placedObject& object
)
{
    const vector span = container.span();
    for (label i = 0; i < maxAttempts_; ++i)
    {
        object.centre = container.min();
        object.centre.x() += span.x()*random().sample01<scalar>();
        object.centre.y() += span.y()*random().sample01<scalar>();
        object.rotation =
            randomRotation_ ? randomRotation() : rotation(rotation_);

        const outline candidate = space.placedOutline(object);
        if
        (
            packing::inside(candidate, container, 0)
         && space.findConflict(candidate, minimumGap()) < 0
        )
        {
            return true;
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
        {
            "region", "number", "areaFraction", "rotation", "randomRotation",
            "maxAttempts"
        },
        3*space.spacing(),
        dict.lookupOrDefault<scalar>("minimumGap", 3*space.spacing())
    ),
    shape_(readShape(dict, space)),
    randomRotation_(dict.lookupOrDefault<Switch>("randomRotation", true)),
    rotation_(dict.lookupOrDefault<scalar>("rotation", 0)),
    maxAttempts_(readAtLeast(dict, "maxAttempts", 10000, 1))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::randomPlacement::place(packing& space)
{
    const boundBox container(readContainer(space));
    const label number = readNumber(space, shape_);

    for (label i = 0; i < number; ++i)
    {
        placedObject object = newObject(shape_, container.min(), tensor::I);
        if (!findPlace(space, container, object))
        {
            FatalIOErrorInFunction(dict())
                << "Entry '"
                << (dict().found("number") ? "number" : "areaFraction")
                << "' of placement " << name() << " asks for " << number
                << " objects of shape " << space.shapeNames()[shape_]
                << " but there is no room for more than " << i
                << " found in " << maxAttempts_ << " attempts (maxAttempts)"
                << nl << "Take fewer objects, a smaller minimumGap ("
                << minimumGap() << " m), or type packed"
                << exit(FatalIOError);
        }
        space.insert(object);
    }
}


// ************************************************************************* //
