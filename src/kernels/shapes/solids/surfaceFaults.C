// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFaults.H"
#include "boundBox.H"
#include "OStringStream.H"
#include "selfIntersections.H"

#include <algorithm>
#include <cmath>
#include <numeric>
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


//- "<number> <what>, the first at <place>"; empty if the number is zero
static string describe
(
    const label number,
    const char* what,
    const point& place
)
{
    if (!number)
    {
        return string();
    }
    OStringStream os;
    os << "has " << number << ' ' << what << ", the first at " << place;
    return os.str();
}


//- Faces without an area: a corner that is on the opposite edge, or nearly
static string flatFaces(const shapeMesh& surface)
{
    label number = 0;
    point place(Zero);
    for (const surfaceFace& f : surface.faces)
    {
        const point& a = surface.points[f[0]];
        const vector b = surface.points[f[1]] - a;
        const vector c = surface.points[f[2]] - a;
        const scalar longest = max(magSqr(b), max(magSqr(c), magSqr(c - b)));
        if (!(mag(b^c) > 1e-8*longest) && number++ == 0)
        {
            place = a;
        }
    }
    return describe(number, "triangles without an area", place);
}


//- Edges with a number of faces that is not two, or faces that do not agree in
//  their direction
static string badEdges
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
        nOpen ? "is not closed: it " + describe(nOpen, "open edges", open)
      : nBranched
      ? describe(nBranched, "edges of more than two triangles", branched)
      : nTurned
      ? "is not oriented: it "
      + describe(nTurned, "edges where front meets back", turned)
      : string();
}


//- Pieces that the sides do not join
static string pieces
(
    const shapeMesh& surface,
    const std::vector<faceSide>& all
)
{
    // The lowest face of the piece, found by way of others
    labelList root(surface.faces.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](label facei)
    {
        while (root[facei] != facei)
        {
            facei = root[facei] = root[root[facei]];
        }
        return facei;
    };
    label number = surface.faces.size();
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
    {
        const label a = find(all[i].face), b = find(all[i + 1].face);
        if (all[i].sameEdge(all[i + 1]) && a != b)
        {
            root[max(a, b)] = min(a, b);
            --number;
        }
    }
    if (number == 1)
    {
        return string();
    }
    OStringStream os;
    os << "has " << number << " pieces instead of one";
    return os.str();
}

} // End namespace surfaceFaults
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsi::surfaceFaults::first(const shapeMesh& surface)
{
    for (const point& p : surface.points)
    {
        if (!std::isfinite(magSqr(p)))
        {
            return "has points that are not numbers";
        }
    }

    const std::vector<faceSide> all(sides(surface));
    string fault(flatFaces(surface));
    if (fault.empty())
    {
        fault = badEdges(surface, all);
    }
    if (fault.empty())
    {
        fault = pieces(surface, all);
    }
    if (fault.empty())
    {
        point place(Zero);
        const label number = selfIntersections::count(surface, place);
        fault = describe(number, "pairs of triangles that meet", place);
    }
    return fault;
}


// ************************************************************************* //
