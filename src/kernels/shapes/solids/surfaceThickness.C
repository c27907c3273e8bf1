// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceThickness.H"
#include "boundBox.H"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace surfaceThickness
{

typedef CGAL::Simple_cartesian<double> kernel;
typedef std::vector<kernel::Triangle_3> triangleList;
typedef CGAL::AABB_triangle_primitive<kernel, triangleList::const_iterator>
    primitive;
typedef CGAL::AABB_tree<CGAL::AABB_traits<kernel, primitive>> searchTree;

static kernel::Point_3 toCgal(const point& p)
{
    return kernel::Point_3(p.x(), p.y(), p.z());
}


//- Twice the area, along the outward normal [m2]
static vector normal(const shapeMesh& surface, const label facei)
{
    const surfaceFace& f = surface.faces[facei];
    const point& a = surface.points[f[0]];
    return (surface.points[f[1]] - a)^(surface.points[f[2]] - a);
}


//- Thickness below a face [m]; GREAT if no face faces it
static scalar below
(
    const shapeMesh& surface,
    const triangleList& triangles,
    const searchTree& tree,
    const label facei
)
{
    const surfaceFace& f = surface.faces[facei];
    const point middle =
        (surface.points[f[0]] + surface.points[f[1]] + surface.points[f[2]])/3;
    const vector n(normal(surface, facei));
    const auto met = tree.first_intersection
    (
        kernel::Ray_3
        (
            toCgal(middle), kernel::Vector_3(-n.x(), -n.y(), -n.z())
        ),
        [&](const triangleList::const_iterator& other)
        {
            return other - triangles.begin() == facei;
        }
    );
    const kernel::Point_3* place =
        met ? boost::get<kernel::Point_3>(&met->first) : nullptr;
    if (!place)
    {
        return GREAT;
    }
    const vector opposite(normal(surface, met->second - triangles.begin()));
    return
        (n & opposite) < -0.966*mag(n)*mag(opposite)
      ? mag(point(place->x(), place->y(), place->z()) - middle)
      : GREAT;
}

} // End namespace surfaceThickness
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::surfaceThickness::smallest(const shapeMesh& surface)
{
    triangleList triangles;
    for (const surfaceFace& f : surface.faces)
    {
        triangles.emplace_back
        (
            toCgal(surface.points[f[0]]),
            toCgal(surface.points[f[1]]),
            toCgal(surface.points[f[2]])
        );
    }
    const searchTree tree(triangles.begin(), triangles.end());

    scalar result = GREAT;
    forAll(surface.faces, facei)
    {
        result = min(result, below(surface, triangles, tree, facei));
    }
    return
        result < GREAT
      ? result
      : cmptMin(boundBox(surface.points, false).span());
}


// ************************************************************************* //
