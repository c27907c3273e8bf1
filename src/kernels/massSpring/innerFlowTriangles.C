// SPDX-License-Identifier: GPL-3.0-or-later

#include "innerFlow.H"
#include "triangulation.H"
#include "error.H"

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
    const List<bodyElement> renewed
    (
        triangulation::triangulate
        (
            points,
            pointField(SubList<point>(points, nBoundary))
        )
    );

    // Triangles that cover the inside use all nodes: their number is fixed
    if (renewed.size() != triangles.size() || !(quality(renewed, x) > 0))
    {
        FatalErrorInFunction
            << "The outline of a membrane crosses itself, or inner nodes have"
            << " left it" << nl << "There are " << renewed.size()
            << " triangles of quality " << quality(renewed, x)
            << " in the place of " << triangles.size()
            << exit(FatalError);
    }
    triangles = renewed;
    return true;
}


// ************************************************************************* //
