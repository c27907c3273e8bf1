// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeMesh.H"
#include "unitConversion.H"

#include <set>
#include <utility>

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
        for (label i = 0; i < 3; ++i)
        {
            const point& a = points[element[i]];
            const vector b = points[element[(i + 1) % 3]] - a;
            const vector c = points[element[(i + 2) % 3]] - a;
            largestCosine = max(largestCosine, (b & c)/(mag(b)*mag(c)));
        }
    }
    return radToDeg(std::acos(min(largestCosine, scalar(1))));
}


// ************************************************************************* //
