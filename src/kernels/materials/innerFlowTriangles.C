// SPDX-License-Identifier: GPL-3.0-or-later

#include "innerFlow.H"
#include "triangulation.H"
#include "error.H"

#include <exception>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Advice that mostly helps where a membrane breaks
static const char* const advice =
    "\nTake a smaller deltaT or maxCo, a larger range of contact, selfContact"
    " yes,\nor a filling of more than a tenth of the fluid's viscosity";


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::innerFlow::renew
(
    List<bodyElement>& triangles,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const label nBoundary
)
{
    const scalar allowedQuality = 0.4;
    if (quality(triangles, x) > allowedQuality)
    {
        return false;
    }

    pointField points(x.rows());
    forAll(points, i)
    {
        points[i] = point(x(i, 0), x(i, 1), 0);
    }
    const pointField outline(SubList<point>(points, nBoundary));
    List<bodyElement> renewed;
    try
    {
        renewed = triangulation::triangulate(points, outline);
    }
    catch (const std::exception&)
    {
        FatalErrorInFunction
            << "The outline of the membrane about " << average(outline)
            << " crosses itself" << advice << exit(FatalError);
    }

    // Triangles that cover the inside use all nodes: their number is fixed
    if (renewed.size() != triangles.size() || !(quality(renewed, x) > 0))
    {
        FatalErrorInFunction
            << "Inner nodes of the membrane about " << average(outline)
            << " have left it: " << renewed.size()
            << " triangles of quality " << quality(renewed, x)
            << " in the place of " << triangles.size() << advice
            << exit(FatalError);
    }
    triangles = renewed;
    return true;
}


// ************************************************************************* //
