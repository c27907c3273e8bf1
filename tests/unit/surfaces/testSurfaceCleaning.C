// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/badShape.H"
#include "surfaceTools.H"

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceCleaning, flatTriangleGivesItsCornerToItsNeighbour)
{
    // A box 3 x 2 x 1, with a corner on an edge, in a triangle without an area
    const fileName file
    (
        fileOf
        (
            "flat.obj",
            "v 0 0 0\nv 0 0 1\nv 0 2 0\nv 0 2 1\n"
            "v 3 0 0\nv 3 0 1\nv 3 2 0\nv 3 2 1\nv 1.5 0 0\n"
            "f 1 2 4\nf 1 4 3\nf 5 7 8\nf 5 8 6\nf 9 5 6\nf 9 6 1\n"
            "f 1 6 2\nf 3 4 8\nf 3 8 7\nf 1 3 7\nf 1 7 5\nf 2 6 8\n"
            "f 2 8 4\nf 1 5 9\n"
        )
    );
    const autoPtr<solidShape> body
    (
        solidOf("type surface; file \"flat.obj\";")
    );
    EXPECT_NEAR(body->volume(), 6, 1e-12);
    const shapeMesh mesh(body->surface());
    EXPECT_EQ(mesh.faces.size(), 14);
    EXPECT_EQ(surfaceTools::nOpenEdges(mesh.faces), 0);
    for (const surfaceFace& f : mesh.faces)
    {
        EXPECT_FALSE(surfaceTools::isFlat(mesh.points, f));
    }
    rm(file);
}


TEST(surfaceCleaning, pointsNearerThanAHairAreOne)
{
    // A tetrahedron whose fourth corner is four points
    const fileName file
    (
        fileOf
        (
            "hair.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 1.000000001\n"
            "v 1e-9 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 5\nf 3 1 6\nf 4 5 6\n"
        )
    );
    const autoPtr<solidShape> body
    (
        solidOf("type surface; file \"hair.obj\";")
    );
    EXPECT_EQ(body->surface().points.size(), 4);
    EXPECT_NEAR(body->volume(), 1.0/6, 1e-8);
    rm(file);
}


TEST(surfaceCleaning, placeAndSizeDoNotChangeTheShape)
{
    const autoPtr<solidShape> sphere(solidOf("type sphere; radius 1;"));
    const shapeMesh unit(sphere->surface());
    const scalar volume = surfaceTools::volume(unit.points, unit.faces);
    for (const scalar size : {1e-30, 1.0, 1e10})
    {
        const fileName file("moved.obj");
        {
            std::ofstream os(file);
            os.precision(17);
            for (point p : unit.points)
            {
                p = size*(p + vector(0, 100, 300));
                os  << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
            }
            for (const surfaceFace& f : unit.faces)
            {
                os  << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1
                    << '\n';
            }
        }
        const autoPtr<solidShape> body
        (
            solidOf("type surface; file \"moved.obj\";")
        );
        EXPECT_NEAR(body->volume()/pow3(size), volume, 1e-10);
        EXPECT_NEAR(body->minimumThickness()/size, 2, 1e-2);
        rm(file);
    }
}


// ************************************************************************* //
