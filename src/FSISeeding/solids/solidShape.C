// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidShape.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"
#include "readBetween.H"
#include "surfaceThickness.H"
#include "surfaceTools.H"
#include "tetrahedralisation.H"
#include "unitConversion.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The icosahedron with corners on the unit sphere
static shapeMesh icosahedron()
{
    const scalar g = 0.5*(1 + std::sqrt(5.0));
    shapeMesh result;
    result.points = pointField
    ({
        point(-1, g, 0), point(1, g, 0), point(-1, -g, 0), point(1, -g, 0),
        point(0, -1, g), point(0, 1, g), point(0, -1, -g), point(0, 1, -g),
        point(g, 0, -1), point(g, 0, 1), point(-g, 0, -1), point(-g, 0, 1)
    });
    result.points /= mag(result.points[0]);
    result.faces = List<surfaceFace>
    ({
        {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11},
        {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
        {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9},
        {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}
    });
    return result;
}


//- Divide each triangle of a surface on the unit sphere into four
static void refine(shapeMesh& surface)
{
    DynamicList<point> points(surface.points);
    std::map<std::pair<label, label>, label> middles;
    const auto middle = [&](const label a, const label b)
    {
        const auto added = middles.emplace(std::minmax(a, b), points.size());
        if (added.second)
        {
            points.append(normalised(points[a] + points[b]));
        }
        return added.first->second;
    };

    DynamicList<surfaceFace> faces;
    for (const surfaceFace& f : surface.faces)
    {
        const label ab = middle(f[0], f[1]);
        const label bc = middle(f[1], f[2]);
        const label ca = middle(f[2], f[0]);
        faces.append(surfaceFace({f[0], ab, ca}));
        faces.append(surfaceFace({f[1], bc, ab}));
        faces.append(surfaceFace({f[2], ca, bc}));
        faces.append(surfaceFace({ab, bc, ca}));
    }
    surface.points = points;
    surface.faces = faces;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::solidShape::edgeAngle()
{
    return degToRad(40.0);
}


Foam::vector Foam::fsi::solidShape::readLengths
(
    const dictionary& dict,
    const word& key
)
{
    const vector lengths(readFinite(dict, key));
    if (!(cmptMin(lengths) > 1e-50))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << lengths << " but all must be > 0" << exit(FatalIOError);
    }
    return lengths;
}


Foam::fsi::shapeMesh Foam::fsi::solidShape::sphereImage
(
    const std::function<point(const vector&)>& image
)
{
    shapeMesh result(icosahedron());
    for (label level = 0; level < 5; ++level)
    {
        refine(result);
    }
    for (point& p : result.points)
    {
        p = image(p);
    }
    result.nBoundary = result.points.size();
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::solidShape::cornerAngle() const
{
    return constant::mathematical::pi;
}


Foam::fsi::shapeMesh Foam::fsi::solidShape::mesh
(
    const scalar nodeSpacing,
    const meshGrading& grading,
    const bool filled
) const
{
    shapeMesh result
    (
        tetrahedralisation::mesh
        (
            surface(), cornerAngle(), nodeSpacing, grading, filled
        )
    );
    result.points -= surfaceTools::centroid(result.points, result.faces);
    result.points *= std::cbrt
    (
        volume()/surfaceTools::volume(result.points, result.faces)
    );
    return result;
}


Foam::boundBox Foam::fsi::solidShape::bounds() const
{
    const shapeMesh body(surface());
    const point centre(surfaceTools::centroid(body.points, body.faces));
    return boundBox(pointField(body.points - centre), false);
}


Foam::scalar Foam::fsi::solidShape::minimumThickness() const
{
    // In units of its size: CGAL asks for powers of lengths
    shapeMesh body(surface());
    const scalar size = boundBox(body.points, false).mag();
    body.points /= size;
    return size*surfaceThickness::smallest(body);
}


// ************************************************************************* //
