// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangulation.H"
#include "outlineTools.H"
#include "boundBox.H"
#include "DynamicList.H"

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



//- Points of a triangular lattice inside the polygon, at least `clearance`
//  from its sides. The shift is in parts of the lattice spacing.
static pointField lattice
(
    const pointField& polygon,
    const scalar size,
    const scalar clearance,
    const vector& shift
)
{
    const boundBox box(polygon, false);
    const scalar rowHeight = 0.5*std::sqrt(3.0)*size;
    const label nRows = label(box.span().y()/rowHeight) + 2;
    const label nColumns = label(box.span().x()/size) + 2;

    DynamicList<point> points;
    for (label j = -1; j < nRows; ++j)
    {
        for (label i = -1; i < nColumns; ++i)
        {
            const point p
            (
                box.min().x() + size*(i + shift.x() + 0.5*(j & 1)),
                box.min().y() + rowHeight*(j + shift.y()),
                0
            );
            if
            (
                outlineTools::contains(polygon, p)
             && outlineTools::distance(polygon, p) > clearance
            )
            {
                points.append(p);
            }
        }
    }
    return pointField(std::move(points));
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
//  the centroid takes its place in a triangle that does not contain it
static void smooth(shapeMesh& mesh)
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
        for (label i = 0; i < 3; ++i)
        {
            weights[e[i]] += volumes[elementi];
            sums[e[i]] += volumes[elementi]*centre;
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
    const pointField& inner
)
{
    shapeMesh result;
    result.points = polygon;
    result.points.append(inner);
    result.nBoundary = polygon.size();
    result.elements = triangulate(result.points, polygon);

    for (label sweep = 0; sweep < 20; ++sweep)
    {
        smooth(result);
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


Foam::fsi::shapeMesh Foam::fsi::triangulation::mesh
(
    const pointField& polygon,
    const scalar size
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
                    lattice(polygon, size, clearance*size, shift)
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

    best.faces.resize(polygon.size());
    forAll(best.faces, i)
    {
        best.faces[i][0] = i;
        best.faces[i][1] = polygon.fcIndex(i);
        best.faces[i][2] = -1;
    }
    return best;
}


// ************************************************************************* //
