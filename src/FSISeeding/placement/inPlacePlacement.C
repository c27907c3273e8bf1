// SPDX-License-Identifier: GPL-3.0-or-later

#include "inPlacePlacement.H"
#include "openfoamVersion.H"
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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Is a shape NAME_1, NAME_2.. one of the pieces of a shape NAME?
static bool isPiece(const word& shape, const word& name)
{
    const std::size_t n = name.size();
    return
        shape.size() > n + 1 && shape.compare(0, n, name) == 0
     && shape[n] == '_'
     && shape.find_first_not_of("0123456789", n + 1) == std::string::npos;
}

} // End namespace fsi
} // End namespace Foam


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
    DynamicList<label> shapes;
    forAll(space.shapeNames(), i)
    {
        if (isPiece(space.shapeNames()[i], shape))
        {
            shapes.append(i);
        }
    }
    if (shapes.empty() || isIn(space.shapeNames(), shape))
    {
        shapes = labelList(1, readShape(dict(), space));
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
