// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangulation.H"
#include "innerNodes.H"
#include "outlineTools.H"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Unique_hash_map.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace triangulation
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef CGAL::Triangulation_vertex_base_with_info_2<label, kernel> vertexBase;
typedef CGAL::Constrained_triangulation_face_base_2<kernel> faceBase;
typedef CGAL::Constrained_Delaunay_triangulation_2
<
    kernel,
    CGAL::Triangulation_data_structure_2<vertexBase, faceBase>
> delaunay;

typedef CGAL::Unique_hash_map<delaunay::Face_handle, bool> faceMarks;


//- Triangles that are reached from infinity without crossing a side. Their
//  centres do not tell: nodes of a straight side are in line up to rounding,
//  and may have a triangle of no area outside
static faceMarks facesOutside(const delaunay& triangles)
{
    faceMarks outside(false);
    std::vector<delaunay::Face_handle> front(1, triangles.infinite_face());
    outside[front[0]] = true;
    while (!front.empty())
    {
        const delaunay::Face_handle face = front.back();
        front.pop_back();
        for (int i = 0; i < 3; ++i)
        {
            const delaunay::Face_handle next = face->neighbor(i);
            if (!face->is_constrained(i) && !outside[next])
            {
                outside[next] = true;
                front.push_back(next);
            }
        }
    }
    return outside;
}


//- Circumcentre of a triangle in the x-y plane
static point circumcentre(const point& a, const point& b, const point& c)
{
    const vector u = b - a, v = c - a;
    const scalar twice = 2*(u.x()*v.y() - u.y()*v.x());
    return a + vector
    (
        (v.y()*magSqr(u) - u.y()*magSqr(v))/twice,
        (u.x()*magSqr(v) - v.x()*magSqr(u))/twice,
        0
    );
}


//- Move the inner nodes to the average circumcentre of their triangles;
//  the centroid takes its place in a triangle that does not contain it. The
//  density of nodes is kept by weights of area over the third power of the
//  wanted size.
static void smooth(shapeMesh& mesh, const scalarField& sizes)
{
    const scalarField volumes(mesh.elementVolumes());
    scalarField weights(mesh.points.size(), Zero);
    pointField sums(mesh.points.size(), Zero);

    forAll(mesh.elements, elementi)
    {
        const bodyElement& e = mesh.elements[elementi];
        const pointField corners
        ({
            mesh.points[e[0]], mesh.points[e[1]], mesh.points[e[2]]
        });
        point centre = circumcentre(corners[0], corners[1], corners[2]);
        if (!outlineTools::contains(corners, centre))
        {
            centre = (corners[0] + corners[1] + corners[2])/3;
        }
        const scalar weight =
            volumes[elementi]
           /pow3((sizes[e[0]] + sizes[e[1]] + sizes[e[2]])/3);
        for (label i = 0; i < 3; ++i)
        {
            weights[e[i]] += weight;
            sums[e[i]] += weight*centre;
        }
    }
    for (label i = mesh.nBoundary; i < mesh.points.size(); ++i)
    {
        mesh.points[i] = sums[i]/weights[i];
    }
}


//- Mesh with the given inner nodes, which are moved
static shapeMesh smoothMesh
(
    const pointField& polygon,
    const innerNodes& inner
)
{
    shapeMesh result;
    result.points = polygon;
    result.points.append(inner.points());
    result.nBoundary = polygon.size();
    scalarField sizes(polygon.size(), 1);
    sizes.append(inner.sizes());
    result.elements = triangulate(result.points, polygon);

    for (label sweep = 0; sweep < 20; ++sweep)
    {
        smooth(result, sizes);
        result.elements = triangulate(result.points, polygon);
    }
    return result;
}

} // End namespace triangulation
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsi::bodyElement> Foam::fsi::triangulation::triangulate
(
    const pointField& points,
    const pointField& polygon
)
{
    // Each search begins at the last place: neighbours follow each other
    delaunay triangles;
    std::vector<delaunay::Vertex_handle> vertices;
    delaunay::Face_handle last;
    forAll(points, i)
    {
        vertices.push_back
        (
            triangles.insert
            (
                kernel::Point_2(points[i].x(), points[i].y()),
                last
            )
        );
        vertices.back()->info() = i;
        last = vertices.back()->face();
    }
    forAll(polygon, i)
    {
        triangles.insert_constraint
        (
            vertices[i],
            vertices[polygon.fcIndex(i)]
        );
    }

    const faceMarks outside(facesOutside(triangles));
    DynamicList<bodyElement> elements;
    for (auto face : triangles.finite_face_handles())
    {
        if (outside[face])
        {
            continue;
        }
        bodyElement element(-1);
        for (label i = 0; i < 3; ++i)
        {
            element[i] = face->vertex(i)->info();
        }
        elements.append(element);
    }
    return List<bodyElement>(std::move(elements));
}


Foam::List<Foam::fsi::surfaceFace> Foam::fsi::triangulation::sides
(
    const pointField& polygon
)
{
    List<surfaceFace> result(polygon.size());
    forAll(result, i)
    {
        result[i] = surfaceFace({i, polygon.fcIndex(i), -1});
    }
    return result;
}


Foam::fsi::shapeMesh Foam::fsi::triangulation::mesh
(
    const pointField& polygon,
    const scalar size,
    const meshGrading& grading
)
{
    shapeMesh best;
    scalar bestAngle = -1;

    for (const scalar clearance : {0.6, 0.7, 0.8})
    {
        for (const vector& shift : {vector(0, 0, 0), vector(0.5, 0.5, 0)})
        {
            shapeMesh trial
            (
                smoothMesh
                (
                    polygon,
                    innerNodes(polygon, size, grading, clearance*size, shift)
                )
            );
            const scalar angle = trial.smallestAngle();
            if (angle > bestAngle)
            {
                bestAngle = angle;
                best = trial;
            }
        }
    }

    best.faces = sides(polygon);
    return best;
}


// ************************************************************************* //
