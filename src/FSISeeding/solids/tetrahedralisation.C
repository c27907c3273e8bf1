// SPDX-License-Identifier: GPL-3.0-or-later

#include "tetrahedralisation.H"
#include "boundBox.H"
#include "DynamicList.H"
#include "filledCells.H"
#include "noTraps.H"
#include "surfaceDepth.H"
#include "surfaceTools.H"
#include "unitConversion.H"

#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // in Boost
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <array>
#include <unordered_map>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace tetrahedralisation
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef CGAL::Mesh_polyhedron_3<kernel>::type polyhedron;
typedef CGAL::Polyhedral_mesh_domain_with_features_3<kernel> meshDomain;
typedef CGAL::Mesh_triangulation_3<meshDomain>::type triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3
<
    triangulation,
    meshDomain::Corner_index,
    meshDomain::Curve_index
> meshComplex;
typedef CGAL::Mesh_criteria_3<triangulation> meshCriteria;
typedef triangulation::Vertex_handle vertex;


//- Circumradii, distance of the surface and angle that give edges of unit
//  mean length
static const scalar facetSize = 0.73;
static const scalar cellSize = 0.75;
static const scalar facetDistance = 0.11;
static const scalar facetAngle = 25;

//- Dihedral angle up to which tetrahedra are improved [degrees]
static const scalar sliverAngle = 12;


namespace
{

//- Circumradius of tetrahedra at a place, in units of the node spacing
class sizeField
{
    const surfaceDepth& depth_;
    const meshGrading& grading_;

    //- No tetrahedra are wanted, or all of the same size
    const bool filled_;
    const bool even_;

public:

    typedef kernel::FT FT;

    sizeField
    (
        const surfaceDepth& depth,
        const meshGrading& grading,
        const bool filled,
        const bool even
    )
    :
        depth_(depth),
        grading_(grading),
        filled_(filled),
        even_(even)
    {}

    template<class Index>
    FT operator()(const kernel::Point_3& p, const int, const Index&) const
    {
        if (!filled_ || even_)
        {
            return filled_ ? cellSize : 1e6;
        }
        const point place(p.x(), p.y(), p.z());
        return cellSize*grading_.size(depth_(place));
    }
};

} // End anonymous namespace


static polyhedron polyhedronOf(const shapeMesh& surface)
{
    std::vector<kernel::Point_3> points;
    for (const point& p : surface.points)
    {
        points.emplace_back(p.x(), p.y(), p.z());
    }
    std::vector<std::array<std::size_t, 3>> faces(surface.faces.size());
    forAll(surface.faces, i)
    {
        std::copy_n(surface.faces[i].begin(), 3, faces[i].begin());
    }
    polyhedron body;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh
    (
        points, faces, body
    );
    return body;
}


//- Boundary faces and tetrahedra of the complex, in units of the size
static shapeMesh extract(const meshComplex& complex)
{
    shapeMesh result;

    // Labels of vertices in the order in which they are met
    std::unordered_map<const void*, label> labels;
    DynamicList<point> points;
    const auto labelOf = [&](const vertex& v)
    {
        const auto added = labels.emplace(&*v, points.size());
        if (added.second)
        {
            const auto& p = v->point();
            points.append(point(p.x(), p.y(), p.z()));
        }
        return added.first->second;
    };

    const filledCells<meshComplex> filled(complex);
    DynamicList<surfaceFace> faces;
    filled.forAllFacets([&](const triangulation::Facet& facet)
    {
        // CGAL's faces turn clockwise seen from the cell they belong to
        surfaceFace face;
        for (int i = 0; i < 3; ++i)
        {
            const int corner =
                triangulation::vertex_triple_index(facet.second, i);
            face[i] = labelOf(facet.first->vertex(corner));
        }
        faces.append(face);
    });
    result.faces = faces;
    result.nBoundary = points.size();

    DynamicList<bodyElement> elements;
    filled.forAllCells([&](const triangulation::Cell_handle& cell)
    {
        bodyElement element;
        for (int i = 0; i < 4; ++i)
        {
            element[i] = labelOf(cell->vertex(i));
        }
        elements.append(element);
    });
    result.elements = elements;
    result.points = points;
    return result;
}


//- Better tetrahedra, by numbers of passes and not by time
static void optimise(meshComplex& complex, const meshDomain& domain)
{
    namespace parameters = CGAL::parameters;
    CGAL::odt_optimize_mesh_3
    (
        complex,
        domain,
        parameters::max_iteration_number = 20,
        parameters::time_limit = 0
    );
    CGAL::perturb_mesh_3
    (
        complex,
        domain,
        parameters::time_limit = 0,
        parameters::sliver_bound = sliverAngle
    );
    CGAL::exude_mesh_3
    (
        complex,
        parameters::time_limit = 0,
        parameters::sliver_bound = sliverAngle
    );
}

} // End namespace tetrahedralisation
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::tetrahedralisation::mesh
(
    shapeMesh surface,
    const scalar cornerAngle,
    const scalar size,
    const meshGrading& grading,
    const bool filled
)
{
    namespace parameters = CGAL::parameters;
    const noTraps whileMeshing;
    // Some of CGAL's functions take numbers from here
    CGAL::get_default_random() = CGAL::Random(0);
    CGAL::Random random(0);

    surface.points = surfaceTools::inUnits(surface.points, surface.faces, size);
    polyhedron body(polyhedronOf(surface));
    meshDomain domain(body, &random);
    domain.detect_features(radToDeg(cornerAngle));
    const surfaceDepth depth(surface);
    const vector span = boundBox(surface.points, false).span();
    const sizeField cells
    (
        depth,
        grading,
        filled,
        0.5*cmptMin(span) < grading.evenDepth()
    );
    const meshCriteria criteria
    (
        parameters::edge_size = 1,
        parameters::facet_angle = facetAngle,
        parameters::facet_size = facetSize,
        parameters::facet_distance = facetDistance,
        parameters::facet_topology = CGAL::MANIFOLD,
        parameters::cell_radius_edge_ratio = filled ? 2 : 0,
        parameters::cell_size = cells
    );
    meshComplex complex = CGAL::make_mesh_3<meshComplex>
    (
        domain,
        criteria,
        parameters::no_perturb(),
        parameters::no_exude()
    );
    if (filled)
    {
        optimise(complex, domain);
    }

    shapeMesh result(extract(complex));
    result.points *= size;
    if (!filled)
    {
        result.elements.clear();
        result.points.resize(result.nBoundary);
    }
    return result;
}


// ************************************************************************* //
