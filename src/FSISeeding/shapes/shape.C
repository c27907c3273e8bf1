// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionaryCheck.H"
#include "openfoamVersion.H"
#include "shape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(shape, 0);
    defineRunTimeSelectionTable(shape, planar);
    defineRunTimeSelectionTable(shape, solid);
}
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::shape> Foam::fsi::shape::New
(
    const dictionary& dict,
    const direction nDims
)
{
    const word shapeType(readName(dict, "type"));

    // The two tables have the same type
    const auto& valid =
        nDims == 2 ? *planarConstructorTablePtr_ : *solidConstructorTablePtr_;
    const auto& other =
        nDims == 2 ? *solidConstructorTablePtr_ : *planarConstructorTablePtr_;

    const auto* constructor = findIn(valid, shapeType);
    if (!constructor)
    {
        FatalIOErrorInFunction(dict)
            << (other.found(shapeType) ? "Entry 'type' " : "Unknown 'type' ")
            << shapeType << " in dictionary " << dict.name();
        if (other.found(shapeType))
        {
            FatalIOError
                << " is a shape in " << (nDims == 2 ? 3 : 2)
                << " dimensions, but the case has " << label(nDims);
        }
        FatalIOError
            << nl << "Valid shapes in " << label(nDims) << " dimensions are "
            << valid.sortedToc() << exit(FatalIOError);
    }
    return (*constructor)(dict);
}


// ************************************************************************* //
