// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxFile.H"
#include "shapes/badShape.H"
#include "newShapeMesh.H"
#include "shapes/soundMesh.H"
#include "triangulation.H"
#include "triSurface.H"

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A surface of an obj file is refused with these words
void expectFault(const string& text, const wordList& words)
{
    const fileName file(fileOf("fault.obj", text));
    expectError("type surface; file \"fault.obj\";", {"file", file}, 3);
    expectError("type surface; file \"fault.obj\";", words, 3);
    rm(file);
}


//- A surface as OpenFOAM writes it
triSurface toTriSurface(const shapeMesh& mesh)
{
    List<labelledTri> faces(mesh.faces.size());
    forAll(faces, i)
    {
        const surfaceFace& f = mesh.faces[i];
        faces[i] = labelledTri(f[0], f[1], f[2], 0);
    }
    return triSurface(faces, mesh.points);
}


//- A prism that stands on a polygon of the x-y plane
shapeMesh prism(const pointField& section, const scalar height)
{
    const label n = section.size();
    shapeMesh result;
    result.points = section;
    result.points.append(pointField(section + vector(0, 0, height)));
    for (const bodyElement& e : triangulation::triangulate(section, section))
    {
        result.faces.append(surfaceFace({e[0], e[2], e[1]}));
        result.faces.append(surfaceFace({e[0] + n, e[1] + n, e[2] + n}));
    }
    for (label i = 0; i < n; ++i)
    {
        const label j = section.fcIndex(i);
        result.faces.append(surfaceFace({i, j, j + n}));
        result.faces.append(surfaceFace({i, j + n, i + n}));
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceFile, isTheSameFromEachFormat)
{
    const shapeMesh torus
    (
        solidOf("type torus; radius 0.1; tubeRadius 0.04;")->surface()
    );
    const scalar volume = surfaceTools::volume(torus.points, torus.faces);
    const triSurface written(toTriSurface(torus));
    for (const word format : {"stl", "stlb", "obj", "off"})
    {
        const fileName file("torus." + format);
        written.write(file);
        const autoPtr<solidShape> body
        (
            solidOf("type surface; file \"" + file + "\"; scale 2;")
        );
        const shapeMesh read(body->surface());
        EXPECT_EQ(read.points.size(), torus.points.size()) << format;
        EXPECT_EQ(read.faces.size(), torus.faces.size()) << format;
        expectSoundSurface(read, 1);

        // Six digits are written
        EXPECT_NEAR(body->volume(), 8*volume, 1e-5*volume) << format;
        EXPECT_NEAR(body->minimumThickness(), 0.16, 0.002) << format;
        rm(file);
    }
}


TEST(surfaceFile, edgesAndCornersAreKept)
{
    const fileName file(fileOf("box.obj", boxPoints + boxFaces));
    const string text("type surface; file \"box.obj\";");
    EXPECT_NEAR(solidOf(text)->minimumThickness(), 1, 1e-12);
    EXPECT_NEAR(solidOf(text)->volume(), 6, 1e-12);

    for (const bool filled : {true, false})
    {
        IStringStream is(text);
        const shapeMesh mesh
        (
            newShapeMesh(dictionary(is), 3, 0.25, gradingOf(""), filled)
        );
        expectSoundSurface(mesh, 0);
        label nCorners = 0;
        for (const point& p : mesh.points)
        {
            nCorners +=
                mag(mag(p.x()) - 1.5) < 1e-9
             && mag(mag(p.y()) - 1) < 1e-9
             && mag(mag(p.z()) - 0.5) < 1e-9;
        }
        EXPECT_EQ(nCorners, 8);
        EXPECT_NEAR(surfaceTools::area(mesh.points, mesh.faces), 22, 1e-9);
        if (filled)
        {
            expectSoundFilling(mesh, 0);
        }
    }

    rm(file);
}


TEST(surfaceFile, insideOutIsTurnedRound)
{
    shapeMesh sphere(solidOf("type sphere; radius 1;")->surface());
    const scalar volume = surfaceTools::volume(sphere.points, sphere.faces);
    for (surfaceFace& f : sphere.faces)
    {
        Swap(f[0], f[1]);
    }
    toTriSurface(sphere).write("turned.obj");
    const shapeMesh read
    (
        solidOf("type surface; file \"turned.obj\";")->surface()
    );
    EXPECT_NEAR
    (
        surfaceTools::volume(read.points, read.faces), volume, 1e-5*volume
    );
    rm("turned.obj");
}


TEST(surfaceFile, thinPlatesAndNecksAreFound)
{
    const auto thickness = [](const pointField& section, const scalar height)
    {
        toTriSurface(prism(section, height)).write("prism.obj");
        const scalar result =
            solidOf("type surface; file \"prism.obj\";")->minimumThickness();
        rm("prism.obj");
        return result;
    };
    const pointField square
    ({
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)
    });
    EXPECT_NEAR(thickness(square, 0.05), 0.05, 1e-9);
    EXPECT_NEAR(thickness(square, 3), 1, 1e-9);

    const pointField bowTie
    ({
        point(-1, -1, 0), point(0, -0.1, 0), point(1, -1, 0),
        point(1, 1, 0), point(0, 0.1, 0), point(-1, 1, 0)
    });
    EXPECT_NEAR(thickness(bowTie, 1), 0.2, 1e-9);
}


TEST(badSurface, isRefusedWithFileKeyAndPlace)
{
    expectError
    (
        "type surface; file \"none.stl\";",
        {"file", "none.stl", "no such file"},
        3
    );
    expectError("type surface;", {"file"}, 3);
    expectError("type surface; file \"none.stl\"; colour 2;", {"file"}, 3);
    expectError("type surface; file \"none.stl\";", {"surface", "circle"}, 2);

    expectFault(boxPoints, {"empty"});
    expectFault
    (
        boxPoints + with(boxFaces, "f 1 2 4\n", ""),
        {"not closed", "3 open edges"}
    );
    expectFault
    (
        boxPoints + boxFaces + "f 1 2 8\n",
        {"not closed"}
    );
    expectFault
    (
        with(boxPoints, "v 3 2 1", "v 3 2 -1") + boxFaces,
        {"meet"}
    );
    expectFault
    (
        // Two tetrahedra with a common edge
        "v 0 0 0\nv 0 0 1\nv 1 0 0.5\nv 1 1 0.5\nv -1 0 0.5\nv -1 -1 0.5\n"
        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
        "f 1 5 2\nf 1 2 6\nf 1 6 5\nf 2 5 6\n",
        {"more than two triangles"}
    );
    expectFault
    (
        "v 0 0 0\nv 1 0 0\nv 3 0 0\nf 1 2 3\nf 1 3 2\n",
        {"2 triangles without an area"}
    );
}


TEST(badSurface, ofTwoPiecesIsRefused)
{
    shapeMesh pair(solidOf("type sphere; radius 1;")->surface());
    const label nPoints = pair.points.size(), nFaces = pair.faces.size();
    pair.points.append(pointField(pair.points + vector(3, 0, 0)));
    for (label i = 0; i < nFaces; ++i)
    {
        const surfaceFace& f = pair.faces[i];
        pair.faces.append
        (
            surfaceFace({f[0] + nPoints, f[1] + nPoints, f[2] + nPoints})
        );
    }
    toTriSurface(pair).write("pair.obj");
    expectError
    (
        "type surface; file \"pair.obj\";", {"pair.obj", "2 pieces"}, 3
    );
    rm("pair.obj");
}


TEST(badSurface, thatIsNoSurfaceIsRefused)
{
    for (const word name : {"text.stl", "text.vtk", "text.off", "text.xyz"})
    {
        const fileName file(fileOf(name, "This is no surface, but a text.\n"));
        expectError
        (
            "type surface; file \"" + file + "\";", {"file", name}, 3
        );
        rm(file);
    }
}


// ************************************************************************* //
