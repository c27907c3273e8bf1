// SPDX-License-Identifier: GPL-3.0-or-later

#include "cuboid.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cuboid, 0);
    addToRunTimeSelectionTable(shape, cuboid, solid);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cuboid::cuboid(const dictionary& dict)
:
    size_(readLengths(dict, "size"))
{
    checkKeys(dict, {"type", "size"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::cuboid::surface() const
{
    // Corner i is at +x with the bit 1, at +y with 2, at +z with 4
    shapeMesh result;
    result.points.setSize(8);
    forAll(result.points, i)
    {
        const vector side(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        result.points[i] = 0.5*cmptMultiply(side, size_);
    }
    result.faces = List<surfaceFace>
    ({
        {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
        {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
        {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}
    });
    result.nBoundary = result.points.size();
    return result;
}


Foam::scalar Foam::fsi::cuboid::cornerAngle() const
{
    return edgeAngle();
}


// ************************************************************************* //
