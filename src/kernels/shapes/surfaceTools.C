// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceTools.H"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::surfaceTools::volume
(
    const UList<point>& points,
    const UList<surfaceFace>& faces
)
{
    scalar sixfold = 0;
    for (const surfaceFace& f : faces)
    {
        const point& origin = points[faces[0][0]];
        const vector a = points[f[0]] - origin;
        const vector b = points[f[1]] - origin;
        const vector c = points[f[2]] - origin;
        sixfold += a & (b^c);
    }
    return sixfold/6;
}


Foam::point Foam::fsi::surfaceTools::centroid
(
    const UList<point>& points,
    const UList<surfaceFace>& faces
)
{
    vector sum(Zero);
    const point& origin = points[faces[0][0]];
    for (const surfaceFace& f : faces)
    {
        const vector a = points[f[0]] - origin;
        const vector b = points[f[1]] - origin;
        const vector c = points[f[2]] - origin;
        sum += (a & (b^c))*(a + b + c);
    }
    return origin + sum/(24*volume(points, faces));
}


Foam::scalar Foam::fsi::surfaceTools::area
(
    const UList<point>& points,
    const UList<surfaceFace>& faces
)
{
    scalar twice = 0;
    for (const surfaceFace& f : faces)
    {
        twice +=
            mag((points[f[1]] - points[f[0]])^(points[f[2]] - points[f[0]]));
    }
    return 0.5*twice;
}


Foam::pointField Foam::fsi::surfaceTools::inUnits
(
    const pointField& points,
    const UList<surfaceFace>& faces,
    const scalar size
)
{
    pointField result(points/size);
    scalar height = 1e-2;
    for (const surfaceFace& f : faces)
    {
        const vector b = result[f[1]] - result[f[0]];
        const vector c = result[f[2]] - result[f[0]];
        const scalar longest = max(mag(b), max(mag(c), mag(c - b)));
        height = min(height, mag(b^c)/max(longest, VSMALL));
    }
    const scalar grid = std::exp2(std::floor(std::log2(1e-4*height + 1e-14)));
    for (point& p : result)
    {
        for (direction d = 0; d < 3; ++d)
        {
            p[d] = grid*std::round(p[d]/grid);
        }
    }
    return result;
}


bool Foam::fsi::surfaceTools::isFlat
(
    const UList<point>& points,
    const surfaceFace& face
)
{
    const vector b = points[face[1]] - points[face[0]];
    const vector c = points[face[2]] - points[face[0]];
    const scalar longest = max(magSqr(b), max(magSqr(c), magSqr(c - b)));
    return !(mag(b^c) > 1e-8*longest);
}


Foam::labelList Foam::fsi::surfaceTools::pieces
(
    const UList<surfaceFace>& faces
)
{
    std::vector<std::pair<std::pair<label, label>, label>> sides;
    forAll(faces, facei)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label a = faces[facei][i], b = faces[facei][(i + 1) % 3];
            sides.emplace_back(std::minmax(a, b), facei);
        }
    }
    std::sort(sides.begin(), sides.end());

    // The lowest face of the piece, found by way of others
    labelList root(faces.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](label facei)
    {
        while (root[facei] != facei)
        {
            facei = root[facei] = root[root[facei]];
        }
        return facei;
    };
    for (std::size_t i = 1; i < sides.size(); ++i)
    {
        if (sides[i].first == sides[i - 1].first)
        {
            const label a = find(sides[i].second);
            const label b = find(sides[i - 1].second);
            root[max(a, b)] = min(a, b);
        }
    }

    labelList result(faces.size());
    label number = 0;
    forAll(faces, facei)
    {
        const label first = find(facei);
        result[facei] = first == facei ? number++ : result[first];
    }
    return result;
}


Foam::label Foam::fsi::surfaceTools::nOpenEdges(const UList<surfaceFace>& faces)
{
    // Each edge, its lower label first, and if it runs from there
    typedef std::pair<std::pair<label, label>, bool> side;
    std::vector<side> sides;
    for (const surfaceFace& f : faces)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label a = f[i], b = f[(i + 1) % 3];
            sides.emplace_back(std::minmax(a, b), a < b);
        }
    }
    std::sort(sides.begin(), sides.end());

    label nOpen = 0;
    for (std::size_t i = 0; i < sides.size(); )
    {
        std::size_t end = i;
        while (end < sides.size() && sides[end].first == sides[i].first)
        {
            ++end;
        }
        nOpen += end - i != 2 || sides[i].second == sides[i + 1].second;
        i = end;
    }
    return nOpen;
}


// ************************************************************************* //
