// SPDX-License-Identifier: GPL-3.0-or-later

#include "newShapeMesh.H"
#include "openfoamVersion.H"
#include "shape.H"
#include "surfaceTools.H"

#include <stdexcept>

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
        << "Entry 'type' " << getEntry<word>(dict, "type")
            << " in dictionary "
        << dict.name() << ": the shape cannot be meshed with nodes "
        << nodeSpacing << " m apart: " << reason << nl
        << "Take nodes that are nearer to each other, or a little farther"
        << exit(FatalIOError);
}


//- Fatal for a shape of more nodes than a computer holds
static void checkSize
(
    const dictionary& dict,
    const shape& body,
    const scalar nodeSpacing
)
{
    const vector cells(body.bounds().span()/nodeSpacing);
    const scalar nodes = body.volume()/pow3(nodeSpacing);
    if (!body.hollow() && (nodes > 1e7 || cmptMax(cells) > 5000))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' " << getEntry<word>(dict, "type")
            << " in dictionary " << dict.name() << ": the shape is "
            << body.bounds().span()
            << " m large, " << cells << " times the distance of nodes, "
            << nodeSpacing << " m" << nl
            << "Lengths are in metres: is it in another unit, as millimetres"
            << " (entry 'scale' of a surface, 1e-3)?" << exit(FatalIOError);
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::newShapeMesh
(
    const shape& body,
    const dictionary& shapeDict,
    const direction nDims,
    const scalar nodeSpacing,
    const meshGrading& grading,
    const bool filled
)
{
    if (nDims == 3)
    {
        checkSize(shapeDict, body, nodeSpacing);
    }
    shapeMesh result;
    try
    {
        result = body.mesh(nodeSpacing, grading, filled);
    }
    catch (const std::logic_error& error)
    {
        // CGAL's
        failMesh(shapeDict, nodeSpacing, error.what());
    }
    if (nDims == 3 && surfaceTools::nOpenEdges(result.faces))
    {
        failMesh
        (
            shapeDict, nodeSpacing,
            "its surface would not be closed, as may happen at an edge sharper"
            " than 40 degrees (blunt it)"
        );
    }
    return result;
}


Foam::fsi::shapeMesh Foam::fsi::newShapeMesh
(
    const dictionary& shapeDict,
    const direction nDims,
    const scalar nodeSpacing,
    const meshGrading& grading,
    const bool filled
)
{
    return newShapeMesh
    (
        *shape::New(shapeDict, nDims),
        shapeDict,
        nDims,
        nodeSpacing,
        grading,
        filled
    );
}


// ************************************************************************* //
