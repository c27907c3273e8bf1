// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceCleaning.H"
#include "DynamicList.H"
#include "joinedPoints.H"
#include "surfaceOrientation.H"
#include "surfaceTools.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace surfaceCleaning
{

//- Append the triangles of a polygon of more than three corners, which may be
//  hollow; false if it has none
static bool appendPolygon
(
    const UList<point>& points,
    const std::vector<label>& corners,
    DynamicList<surfaceFace>& faces
)
{
    typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
    std::vector<kernel::Point_3> places;
    for (const label l : corners)
    {
        places.emplace_back(points[l].x(), points[l].y(), points[l].z());
    }
    typedef CGAL::Triple<int, int, int> corners3;
    std::vector<corners3> triangles;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline
    (
        places, std::back_inserter(triangles)
    );
    for (const corners3& t : triangles)
    {
        faces.append
        (
            surfaceFace
            ({
                corners[t.first], corners[t.second], corners[t.third]
            })
        );
    }
    return triangles.size() + 2 == corners.size();
}


//- Triangles with joined points, without those that have no three corners or
//  are there already
static shapeMesh joined
(
    const surfaceFormats::polygonSoup& soup,
    repairs& done
)
{
    joinedPoints places(1e-8);
    std::set<std::array<label, 3>> known;
    DynamicList<surfaceFace> faces(soup.polygons.size());
    labelList labels(soup.points.size(), -1);
    std::vector<label> corners;
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    {
        corners.clear();
        for (const label l : soup.polygons[i])
        {
            if (labels[l] < 0)
            {
                labels[l] = places.add(soup.points[l]);
            }
            if (corners.empty() || corners.back() != labels[l])
            {
                corners.push_back(labels[l]);
            }
        }
        while (corners.size() > 1 && corners.front() == corners.back())
        {
            corners.pop_back();
        }
        done.collapsed += corners.size() < 3;
        if (corners.size() == 3)
        {
            const surfaceFace face({corners[0], corners[1], corners[2]});
            std::rotate
            (
                corners.begin(),
                std::min_element(corners.begin(), corners.end()),
                corners.end()
            );
            const bool isNew =
                known.insert({corners[0], corners[1], corners[2]}).second;
            done.doubled += !isNew;
            if (isNew)
            {
                faces.append(face);
            }
        }
        else if
        (
            corners.size() > 3
         && !appendPolygon(places.points(), corners, faces)
        )
        {
            throw std::runtime_error
            (
                std::string(soup.unit) + ' ' + std::to_string(soup.places[i])
              + ": the polygon cannot be divided into triangles"
            );
        }
    }
    shapeMesh result;
    result.points = places.points();
    result.faces = faces;
    result.nBoundary = result.points.size();
    return result;
}


//- The triangle on the left of each side
typedef std::map<std::pair<label, label>, label> faceOfSide;

static void setSides
(
    faceOfSide& sides,
    const List<surfaceFace>& faces,
    const label facei
)
{
    const surfaceFace& f = faces[facei];
    for (label i = 0; i < 3; ++i)
    {
        sides[{f[i], f[(i + 1) % 3]}] = facei;
    }
}


//- Exchange the longest side of a flat triangle for the other diagonal of its
//  two triangles; false if the neighbour is flat as well, or there is none
static bool flip(shapeMesh& surface, faceOfSide& sides, const label facei)
{
    surfaceFace f = surface.faces[facei];
    const auto length = [&](const label i)
    {
        return
            magSqr(surface.points[f[(i + 1) % 3]] - surface.points[f[i]]);
    };
    label i = length(1) > length(0) ? 1 : 0;
    i = length(2) > length(i) ? 2 : i;
    const label u = f[i], v = f[(i + 1) % 3], w = f[(i + 2) % 3];

    const auto found = sides.find({v, u});
    if (found == sides.end())
    {
        return false;
    }
    const label otheri = found->second;
    const surfaceFace g = surface.faces[otheri];
    label d = -1;
    for (const label l : g)
    {
        d = l != u && l != v ? l : d;
    }
    if
    (
        d == w || surfaceTools::isFlat(surface.points, g)
     || sides.count({w, d}) || sides.count({d, w})
    )
    {
        return false;
    }
    surface.faces[facei] = surfaceFace({w, u, d});
    surface.faces[otheri] = surfaceFace({w, d, v});
    sides.erase({u, v});
    sides.erase({v, u});
    setSides(sides, surface.faces, facei);
    setSides(sides, surface.faces, otheri);
    return true;
}

} // End namespace surfaceCleaning
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::shapeMesh Foam::fsi::surfaceCleaning::clean
(
    const surfaceFormats::polygonSoup& soup,
    repairs& done
)
{
    shapeMesh surface(joined(soup, done));
    std::set<label> flat;
    forAll(surface.faces, facei)
    {
        if (surfaceTools::isFlat(surface.points, surface.faces[facei]))
        {
            flat.insert(facei);
        }
    }
    done.flat = flat.size();
    done.turned = orientSurface(surface.faces);
    if (flat.empty())
    {
        return surface;
    }
    faceOfSide sides;
    forAll(surface.faces, facei)
    {
        setSides(sides, surface.faces, facei);
    }
    for (bool changed = true; changed && flat.size();)
    {
        changed = false;
        for (auto facei = flat.begin(); facei != flat.end();)
        {
            const bool flipped = flip(surface, sides, *facei);
            changed = changed || flipped;
            facei = flipped ? flat.erase(facei) : std::next(facei);
        }
    }
    return surface;
}


// ************************************************************************* //
