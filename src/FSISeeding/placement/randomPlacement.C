// SPDX-License-Identifier: GPL-3.0-or-later

#include "randomPlacement.H"
#include "Switch.H"
#include "addToRunTimeSelectionTable.H"
#include "readBetween.H"

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
    for (label i = 0; i < maxAttempts_; ++i)
    {
        object.centre = randomCentre(space, container);
        object.rotation = randomRotation_ ? randomRotation() : rotation();

        if (held(space, container, object))
        {
            if (space.findConflict(object, minimumGap()) < 0)
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
    soughtPlacement(name, dict, space, {"randomRotation", "maxAttempts"}),
    randomRotation_(dict.lookupOrDefault<Switch>("randomRotation", true)),
    maxAttempts_(readBetween(dict, "maxAttempts", 10000, 1, 10000000))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::randomPlacement::place(packing& space)
{
    const boundBox container(readContainer(space));
    const label number = readNumber(space);

    const labelList shapes(shapesOf(number));
    for (label i = 0; i < number; ++i)
    {
        placedObject object =
            newObject(shapes[i], container.min(), tensor::I);
        label nConflicts = 0;
        if (!findPlace(space, container, object, nConflicts))
        {
            if (nConflicts == 0)
            {
                // None of the places was in the container
                checkFits(space.placed(object), container);
            }
            OStringStream os;
            os  << "there is no room for more than " << i << " found in "
                << maxAttempts_ << " attempts (maxAttempts): " << nConflicts
                << " were too near to other objects, "
                << maxAttempts_ - nConflicts << " to the walls or the ends of"
                << " the region";
            lackRoom(space, number, os.str());
        }
        space.insert(object);
    }
}


// ************************************************************************* //
