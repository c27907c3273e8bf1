// SPDX-License-Identifier: GPL-3.0-or-later

#include "shortWaves.H"
#include "labelPair.H"
#include "mathematicalConstants.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace shortWaves
{

//- Four nodes in a row along the outline from each boundary node
static List<fourNodes> rows
(
    const List<surfaceFace>& faces,
    const scalar thickness
)
{
    labelList next(faces.size());
    for (const surfaceFace& face : faces)
    {
        next[face[0]] = face[1];
    }
    List<fourNodes> result(next.size());
    forAll(result, nodei)
    {
        fourNodes& four = result[nodei];
        four.difference = FixedList<scalar, 4>({-1, 3, -3, 1});
        four.number = constant::mathematical::twoPi/64;
        four.length = thickness;
        label last = nodei;
        for (label& node : four.nodes)
        {
            node = last;
            last = next[last];
        }
    }
    return result;
}


//- The two triangles at an edge: its nodes, then those opposite
static fourNodes hinge
(
    const pointField& x,
    const FixedList<label, 4>& nodes
)
{
    fourNodes four;
    four.nodes = nodes;
    const vector edge(x[nodes[1]] - x[nodes[0]]);
    const vector across(x[nodes[3]] - x[nodes[2]]);
    const vector between(x[nodes[2]] - x[nodes[0]]);

    // The diagonals intersect as seen along the normal of both; the second
    // always meets the line of the edge between its ends
    const vector normal(edge ^ across);
    const scalar area = max(magSqr(normal), VSMALL);
    const scalar t = ((between ^ across) & normal)/area;
    const scalar s = ((between ^ edge) & normal)/area;
    const scalar inside = min(max(t, 0.0), 1.0);
    four.difference[0] = 2*(1 - inside);
    four.difference[1] = 2*inside;
    four.difference[2] = 2*(s - 1);
    four.difference[3] = -2*s;

    // Length of an edge of the lattice that has as large triangles
    four.number = 4*constant::mathematical::pi/(27*Foam::sqrt(3.0));
    four.length = Foam::sqrt(mag(normal)/Foam::sqrt(3.0));
    return four;
}


//- Four nodes about each edge
static List<fourNodes> hinges
(
    const pointField& points,
    const List<surfaceFace>& faces
)
{
    std::map<labelPair, label> opposite;
    DynamicList<fourNodes> result;
    for (const surfaceFace& f : faces)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label a = f[i], b = f[(i + 1) % 3], c = f[(i + 2) % 3];
            const labelPair edge(min(a, b), max(a, b));
            const auto known = opposite.find(edge);
            if (known == opposite.end())
            {
                opposite[edge] = c;
            }
            else
            {
                result.append
                (
                    hinge
                    (
                        points,
                        FixedList<label, 4>({a, b, known->second, c})
                    )
                );
            }
        }
    }
    return List<fourNodes>(result);
}

} // End namespace shortWaves
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::shortWaves::fourNodes::addForce
(
    const label first,
    const scalar friction,
    const vectorField& v,
    vectorField& force
) const
{
    vector wave(Zero);
    forAll(nodes, i)
    {
        wave += difference[i]*v[first + nodes[i]];
    }
    forAll(nodes, i)
    {
        force[first + nodes[i]] -= friction*difference[i]*wave;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::fsi::shortWaves::fourNodes> Foam::fsi::shortWaves::all
(
    const pointField& points,
    const List<surfaceFace>& faces,
    const direction nDims,
    const scalar thickness
)
{
    return nDims == 2 ? rows(faces, thickness) : hinges(points, faces);
}


// ************************************************************************* //
