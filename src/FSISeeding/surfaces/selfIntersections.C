// SPDX-License-Identifier: GPL-3.0-or-later

#include "selfIntersections.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace selfIntersections
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef CGAL::Surface_mesh<kernel::Point_3> meshType;
typedef meshType::Vertex_index vertexIndex;

} // End namespace selfIntersections
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::selfIntersections::count
(
    const shapeMesh& surface,
    point& place
)
{
    meshType mesh;
    for (const point& p : surface.points)
    {
        mesh.add_vertex(kernel::Point_3(p.x(), p.y(), p.z()));
    }
    label number = 0;
    for (const surfaceFace& f : surface.faces)
    {
        const auto added = mesh.add_face
        (
            vertexIndex(f[0]), vertexIndex(f[1]), vertexIndex(f[2])
        );
        if (added == meshType::null_face() && number++ == 0)
        {
            // Its corner is where two fans meet
            place = surface.points[f[0]];
        }
    }
    if (number)
    {
        return number;
    }

    typedef meshType::Face_index faceIndex;
    std::vector<std::pair<faceIndex, faceIndex>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections
    (
        mesh, std::back_inserter(pairs)
    );
    if (!pairs.empty())
    {
        place = surface.points[surface.faces[label(pairs[0].first)][0]];
    }
    return pairs.size();
}


// ************************************************************************* //
