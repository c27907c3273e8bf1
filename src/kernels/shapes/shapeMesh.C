// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeMesh.H"
#include "unitConversion.H"

#include <set>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Cosine of a triangle's smallest angle
static scalar cosineInTriangle(const pointField& points, const bodyElement& e)
{
    scalar largest = -1;
    for (label i = 0; i < 3; ++i)
    {
        const point& a = points[e[i]];
        const vector b = points[e[(i + 1) % 3]] - a;
        const vector c = points[e[(i + 2) % 3]] - a;
        largest = max(largest, (b & c)/(mag(b)*mag(c)));
    }
    return largest;
}


//- Cosine of a tetrahedron's smallest dihedral angle
static scalar cosineInTetrahedron
(
    const pointField& points,
    const bodyElement& e
)
{
    // Outward normals, each opposite to a corner
    const point& a = points[e[0]];
    const vector b = points[e[1]] - a;
    const vector c = points[e[2]] - a;
    const vector d = points[e[3]] - a;
    const FixedList<vector, 4> normals
    ({
        normalised((c - b)^(d - b)),
        normalised(d^c),
        normalised(b^d),
        normalised(c^b)
    });

    scalar largest = -1;
    for (label i = 0; i < 4; ++i)
    {
        for (label j = i + 1; j < 4; ++j)
        {
            largest = max(largest, -(normals[i] & normals[j]));
        }
    }
    return largest;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::edgeList Foam::fsi::shapeMesh::edges() const
{
    std::set<std::pair<label, label>> found;
    for (const bodyElement& element : elements)
    {
        const label nCorners = element[3] < 0 ? 3 : 4;
        for (label i = 0; i < nCorners; ++i)
        {
            for (label j = i + 1; j < nCorners; ++j)
            {
                found.insert(std::minmax(element[i], element[j]));
            }
        }
    }

    edgeList result(found.size());
    label edgei = 0;
    for (const auto& ends : found)
    {
        result[edgei++] = edge(ends.first, ends.second);
    }
    return result;
}


Foam::scalarField Foam::fsi::shapeMesh::elementVolumes() const
{
    scalarField result(elements.size());
    forAll(elements, elementi)
    {
        const bodyElement& element = elements[elementi];
        const point& a = points[element[0]];
        const vector normal = (points[element[1]] - a)^(points[element[2]] - a);
        result[elementi] =
            element[3] < 0
          ? 0.5*normal.z()
          : (normal & (points[element[3]] - a))/6;
    }
    return result;
}


Foam::scalar Foam::fsi::shapeMesh::smallestAngle() const
{
    scalar largestCosine = -1;
    for (const bodyElement& element : elements)
    {
        largestCosine = max
        (
            largestCosine,
            element[3] < 0
          ? cosineInTriangle(points, element)
          : cosineInTetrahedron(points, element)
        );
    }
    return radToDeg(std::acos(min(largestCosine, scalar(1))));
}


// ************************************************************************* //
