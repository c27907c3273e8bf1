// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfacePredicates.H"
#include "boxPairs.H"
#include "DynamicList.H"
#include "outlineLoop.H"
#include "polygonPredicates.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace surfacePredicates
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef CGAL::Surface_mesh<kernel::Point_3> surfaceMesh;


//- Outline of an object
static pointField polygonOf(const surfaceSet& surfaces, const label objecti)
{
    return pointField(surfaces.points(), outlineLoop(surfaces, objecti));
}


//- Triangles of an object, moved; without faces if they do not make a closed
//  surface
static surfaceMesh meshOf
(
    const surfaceSet& surfaces,
    const label objecti,
    const vector& shift
)
{
    surfaceMesh mesh;
    const label first = surfaces.pointStart()[objecti];
    for (label i = first; i < surfaces.pointStart()[objecti + 1]; ++i)
    {
        const point p(surfaces.points()[i] + shift);
        mesh.add_vertex(kernel::Point_3(p.x(), p.y(), p.z()));
    }

    const labelList& start = surfaces.faceStart();
    for (label facei = start[objecti]; facei < start[objecti + 1]; ++facei)
    {
        const surfaceFace& f = surfaces.faces()[facei];
        const auto corner = [&](const label i)
        {
            return surfaceMesh::Vertex_index(f[i] - first);
        };
        if
        (
            mesh.add_face(corner(0), corner(1), corner(2))
         == surfaceMesh::null_face()
        )
        {
            mesh.clear();
            return mesh;
        }
    }
    if (!CGAL::is_closed(mesh))
    {
        mesh.clear();
    }
    return mesh;
}


//- Do two objects cross, touch or enclose each other, the first one moved?
static bool overlap
(
    const surfaceSet& surfaces,
    const label a,
    const label b,
    const vector& shift
)
{
    if (surfaces.nDims() == 2)
    {
        return polygonPredicates::overlap
        (
            polygonOf(surfaces, a) + shift, polygonOf(surfaces, b)
        );
    }
    return CGAL::Polygon_mesh_processing::do_intersect
    (
        meshOf(surfaces, a, shift),
        meshOf(surfaces, b, Zero),
        CGAL::parameters::do_overlap_test_of_bounded_sides(true)
    );
}

} // End namespace surfacePredicates
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::surfacePredicates::cutsItself
(
    const surfaceSet& surfaces,
    const label objecti
)
{
    if (surfaces.nDims() == 2)
    {
        return !polygonPredicates::isSimple(polygonOf(surfaces, objecti));
    }
    const surfaceMesh mesh(meshOf(surfaces, objecti, Zero));
    return
        mesh.is_empty()
     || CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}


Foam::List<Foam::labelPair> Foam::fsi::surfacePredicates::overlapping
(
    const surfaceSet& surfaces,
    const labelUList& objects,
    const vector& period
)
{
    List<boundBox> boxes(objects.size());
    forAll(boxes, i)
    {
        boxes[i] = surfaces.bounds(objects[i]);
    }

    DynamicList<labelPair> found;
    for (const boxPair& pair : boxPairs(boxes, period, surfaces.nDims()))
    {
        const label a = objects[pair.first], b = objects[pair.second];
        if (overlap(surfaces, a, b, pair.shift))
        {
            found.append(labelPair(a, b));
        }
    }
    std::sort(found.begin(), found.end());
    found.resize(std::unique(found.begin(), found.end()) - found.begin());
    return List<labelPair>(std::move(found));
}


// ************************************************************************* //
