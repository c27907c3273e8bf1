// SPDX-License-Identifier: GPL-3.0-or-later

#include "planarShape.H"
#include "mathematicalConstants.H"
#include "outlineThickness.H"
#include "outlineTools.H"
#include "triangulation.H"
#include "unitConversion.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::fsi::planarShape::sample
(
    const std::function<point(scalar)>& curve
)
{
    const label n = 16384;
    pointField points(n);
    forAll(points, i)
    {
        points[i] = curve(constant::mathematical::twoPi*i/n);
    }
    return points;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::planarShape::cornerAngle() const
{
    return degToRad(20.0);
}


Foam::pointField Foam::fsi::planarShape::outline(const scalar nodeSpacing) const
{
    const pointField fine(outlineTools::counterClockwise(curve()));
    pointField points
    (
        outlineTools::resample(fine, nodeSpacing, cornerAngle())
    );
    points -= outlineTools::centroid(points);
    points *=
        std::sqrt(outlineTools::area(fine)/outlineTools::area(points));
    return points;
}


Foam::fsi::shapeMesh Foam::fsi::planarShape::mesh
(
    const scalar nodeSpacing,
    const meshGrading& grading,
    const bool filled
) const
{
    const pointField nodes(outline(nodeSpacing));
    if (filled)
    {
        return triangulation::mesh(nodes, nodeSpacing, grading);
    }
    shapeMesh result;
    result.points = nodes;
    result.nBoundary = nodes.size();
    result.faces = triangulation::sides(nodes);
    return result;
}


Foam::scalar Foam::fsi::planarShape::volume() const
{
    return mag(outlineTools::area(curve()));
}


Foam::boundBox Foam::fsi::planarShape::bounds() const
{
    const pointField points(curve());
    return boundBox
    (
        pointField(points - outlineTools::centroid(points)),
        false
    );
}


Foam::scalar Foam::fsi::planarShape::minimumThickness() const
{
    // Three hundred nodes around the body show any neck worth meshing
    const pointField fine(outlineTools::counterClockwise(curve()));
    return outlineThickness::smallest
    (
        outlineTools::resample
        (
            fine,
            outlineTools::perimeter(fine)/300,
            cornerAngle()
        )
    );
}


// ************************************************************************* //
