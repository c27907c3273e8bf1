// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "surfacePlace.H"
#include "samples/surfaceSamples.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

//- Triangles between node 0 and nodes around it
surfaceSet fan(const label nFaces, const bool closed)
{
    pointField points(nFaces + 2, Zero);
    List<surfaceFace> faces(nFaces);
    for (label i = 0; i <= nFaces; ++i)
    {
        points[i + 1] = point(std::cos(0.5*i), std::sin(0.5*i), 0);
    }
    forAll(faces, i)
    {
        const label next = closed && i + 1 == nFaces ? 1 : i + 2;
        faces[i] = surfaceFace({0, i + 1, next});
    }
    surfaceSet surfaces(3);
    surfaces.append(points, faces);
    return surfaces;
}


//- The faces at a place, sorted
labelList facesAt
(
    const surfaceSet& surfaces,
    const label facei,
    const FixedList<scalar, 3>& weights
)
{
    DynamicList<label> faces;
    appendFacesAt(surfaces, facei, weights, faces);
    EXPECT_EQ(faces[0], facei);
    labelList sorted(faces);
    sort(sorted);
    return sorted;
}

} // End anonymous namespace


TEST(FacesAtPlace, goesRoundANode)
{
    const FixedList<scalar, 3> node{1, 0, 0};
    for (const bool closed : {false, true})
    {
        const surfaceSet surfaces(fan(5, closed));
        for (label facei = 0; facei < 5; ++facei)
        {
            const labelList all({0, 1, 2, 3, 4});
            EXPECT_EQ(facesAt(surfaces, facei, node), all)
                << "from face " << facei << ", closed " << closed;
        }
    }
}


TEST(FacesAtPlace, goesOverOneEdge)
{
    const surfaceSet surfaces(fan(5, false));
    const FixedList<scalar, 3> inside{0.2, 0.3, 0.5}, edge{0.5, 0, 0.5};
    EXPECT_EQ(facesAt(surfaces, 1, inside), labelList(1, label(1)));
    EXPECT_EQ(facesAt(surfaces, 1, edge), labelList({1, 2}));
    EXPECT_EQ(facesAt(surfaces, 4, edge), labelList(1, label(4)));
}


// ************************************************************************* //
