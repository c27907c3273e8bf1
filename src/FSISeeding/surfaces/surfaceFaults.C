// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFaults.H"
#include "selfIntersections.H"
#include "surfaceTools.H"

#include <algorithm>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace surfaceFaults
{

//- A side of a face: the edge, and if it runs from the lower label
struct faceSide
{
    label a, b, face;
    bool upwards;

    bool sameEdge(const faceSide& other) const
    {
        return a == other.a && b == other.b;
    }

    bool operator<(const faceSide& other) const
    {
        return
            a != other.a ? a < other.a
          : b != other.b ? b < other.b
          : face < other.face;
    }
};


//- All sides, those of an edge one after the other
static std::vector<faceSide> sides(const shapeMesh& surface)
{
    std::vector<faceSide> result;
    forAll(surface.faces, facei)
    {
        const surfaceFace& f = surface.faces[facei];
        for (label i = 0; i < 3; ++i)
        {
            const label a = f[i], b = f[(i + 1) % 3];
            result.push_back({min(a, b), max(a, b), facei, a < b});
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}


//- A number of faults, the first of them at a place; none if it is zero
static surfaceFault describe
(
    const label number,
    const char* what,
    const point& place
)
{
    return
    {
        number ? "has " + Foam::name(number) + ' ' + what : string(),
        place
    };
}


//- Faces without an area
static surfaceFault flatFaces(const shapeMesh& surface)
{
    label number = 0;
    point place(Zero);
    for (const surfaceFace& f : surface.faces)
    {
        if (surfaceTools::isFlat(surface.points, f) && number++ == 0)
        {
            place = surface.points[f[0]];
        }
    }
    return describe(number, "triangles without an area", place);
}


//- Edges with a number of faces that is not two, or faces that do not agree in
//  their direction
static surfaceFault badEdges
(
    const shapeMesh& surface,
    const std::vector<faceSide>& all
)
{
    label nOpen = 0, nBranched = 0, nTurned = 0;
    point open(Zero), branched(Zero), turned(Zero);
    const auto count = [](label& number, point& first, const point& place)
    {
        if (number++ == 0)
        {
            first = place;
        }
    };
    for (auto from = all.begin(), to = from; from != all.end(); from = to)
    {
        to = std::find_if_not
        (
            from, all.end(), [&](const auto& s) { return s.sameEdge(*from); }
        );
        const point middle =
            0.5*(surface.points[from->a] + surface.points[from->b]);
        if (to - from == 1)
        {
            count(nOpen, open, middle);
        }
        else if (to - from > 2)
        {
            count(nBranched, branched, middle);
        }
        else if (from->upwards == (from + 1)->upwards)
        {
            count(nTurned, turned, middle);
        }
    }
    return
        nOpen ? describe(nOpen, "open edges: it is not closed", open)
      : nBranched
      ? describe(nBranched, "edges of more than two triangles", branched)
      : describe
        (
            nTurned,
            "edges where front meets back: it is not oriented",
            turned
        );
}


//- Pieces that no edges join
static surfaceFault pieces(const shapeMesh& surface)
{
    const label number = max(surfaceTools::pieces(surface.faces)) + 1;
    return
    {
        number == 1 ? string()
      : "has " + Foam::name(number) + " pieces instead of one (entry 'piece')",
        surface.points[surface.faces[0][0]]
    };
}

} // End namespace surfaceFaults
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::surfaceFault Foam::fsi::surfaceFaults::first
(
    const shapeMesh& surface
)
{
    const std::vector<faceSide> all(sides(surface));
    surfaceFault fault(flatFaces(surface));
    if (fault.text.empty())
    {
        fault = badEdges(surface, all);
    }
    if (fault.text.empty())
    {
        fault = pieces(surface);
    }
    if (fault.text.empty())
    {
        point place(Zero);
        const label number = selfIntersections::count(surface, place);
        fault = describe(number, "pairs of triangles that meet", place);
    }
    return fault;
}


// ************************************************************************* //
