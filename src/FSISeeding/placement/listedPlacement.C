// SPDX-License-Identifier: GPL-3.0-or-later

#include "listedPlacement.H"
#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "rotations.H"
#include "addToRunTimeSelectionTable.H"
#include "readBetween.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(listedPlacement, 0);
    addToRunTimeSelectionTable(placement, listedPlacement, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::listedPlacement::listedPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    placement(name, dict, space, {"objects"}, 0, 0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::listedPlacement::place(packing& space)
{
    const PtrList<dictionary> entries(dict().lookup("objects"));

    DynamicList<placedObject> objects(entries.size());
    forAll(entries, i)
    {
        // Errors in an entry of a list must name the file as well
        dictionary& entry = const_cast<dictionary&>(entries[i]);
        entry.name() = dict().name() + ".objects[" + Foam::name(i) + ']';
        checkKeys
        (
            entry,
            {"centre", "rotation", "shape", "velocity", "angularVelocity"}
        );

        objects.append
        (
            newObject
            (
                readShape(entry.found("shape") ? entry : dict(), space),
                checkedCentre(readFinite(entry, "centre"), space),
                readRotation(entry, nDims()),
                readVelocity(entry, velocity()),
                readAngularVelocity(entry, angularVelocity())
            )
        );
    }
    insertAll(space, objects, "objects");
}


// ************************************************************************* //
