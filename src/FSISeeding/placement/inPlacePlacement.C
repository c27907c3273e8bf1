// SPDX-License-Identifier: GPL-3.0-or-later

#include "inPlacePlacement.H"
#include "openfoamVersion.H"
#include "shapeParts.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(inPlacePlacement, 0);
    addToRunTimeSelectionTable(placement, inPlacePlacement, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::inPlacePlacement::inPlacePlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    placement(name, dict, space, {}, 0, 0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::inPlacePlacement::place(packing& space)
{
    const word shape(getEntry<word>(dict(), "shape"));
    const labelList shapes(shapeParts::named(shape, space.shapeNames()));
    if (shapes.empty())
    {
        shapeParts::fail(dict(), "shape", shape, space.shapeNames());
    }

    DynamicList<placedObject> objects(shapes.size());
    for (const label shapei : shapes)
    {
        objects.append
        (
            newObject
            (
                shapei,
                checkedCentre(space.place(shapei), space),
                tensor::I
            )
        );
    }
    insertAll(space, objects, "shape");
}


// ************************************************************************* //
