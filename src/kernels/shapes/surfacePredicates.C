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


//- As overlapping, for triangles
static DynamicList<labelPair> overlappingSolids
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
    for (const boxPair& pair : boxPairs(boxes, period, 3))
    {
        const surfaceMesh a
        (
            meshOf(surfaces, objects[pair.first], pair.shift)
        );
        const surfaceMesh b(meshOf(surfaces, objects[pair.second], Zero));
        if
        (
            CGAL::Polygon_mesh_processing::do_intersect
            (
                a,
                b,
                CGAL::parameters::do_overlap_test_of_bounded_sides(true)
            )
        )
        {
            found.append(labelPair(objects[pair.first], objects[pair.second]));
        }
    }
    return found;
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
    DynamicList<labelPair> found;
    if (surfaces.nDims() == 2)
    {
        List<pointField> polygons(objects.size());
        forAll(polygons, i)
        {
            polygons[i] = polygonOf(surfaces, objects[i]);
        }
        found = polygonPredicates::overlapping(polygons, period);
        for (labelPair& pair : found)
        {
            pair = labelPair(objects[pair.first()], objects[pair.second()]);
        }
    }
    else
    {
        found = overlappingSolids(surfaces, objects, period);
    }
    std::sort(found.begin(), found.end());
    found.resize(std::unique(found.begin(), found.end()) - found.begin());
    return List<labelPair>(std::move(found));
}


// ************************************************************************* //
