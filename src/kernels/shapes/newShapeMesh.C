// SPDX-License-Identifier: GPL-3.0-or-later

#include "newShapeMesh.H"
#include "shape.H"
#include "surfaceTools.H"

#include <exception>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Fatal for a shape that cannot be meshed
static void failMesh
(
    const dictionary& dict,
    const scalar nodeSpacing,
    const string& reason
)
{
    FatalIOErrorInFunction(dict)
        << "Entry 'type' " << dict.get<word>("type") << " in dictionary "
        << dict.name() << ": the shape cannot be meshed with nodes "
        << nodeSpacing << " m apart: " << reason << nl
        << "Take nodes that are nearer to each other"
        << exit(FatalIOError);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::newShapeMesh
(
    const dictionary& shapeDict,
    const direction nDims,
    const scalar nodeSpacing,
    const meshGrading& grading,
    const bool filled
)
{
    const autoPtr<shape> body(shape::New(shapeDict, nDims));
    shapeMesh result;
    try
    {
        result = body->mesh(nodeSpacing, grading, filled);
    }
    catch (const std::logic_error& error)
    {
        // CGAL's
        failMesh(shapeDict, nodeSpacing, error.what());
    }
    if (nDims == 3 && surfaceTools::nOpenEdges(result.faces))
    {
        failMesh(shapeDict, nodeSpacing, "its surface would not be closed");
    }
    return result;
}


// ************************************************************************* //
