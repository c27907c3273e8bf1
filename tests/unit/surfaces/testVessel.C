// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxFile.H"
#include "shapes/badShape.H"
#include "newShapeMesh.H"
#include "shapes/soundMesh.H"

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceFile, trianglesTheWrongWayRoundOrTwiceAreMended)
{
    const string faces
    (
        with(boxFaces, "f 1 2 4\nf 1 4 3\n", "f 1 4 2\nf 1 3 4\nf 1 3 4\n")
    );
    const fileName file(fileOf("mended.obj", boxPoints + faces));
    const shapeMesh box
    (
        solidOf("type surface; file \"mended.obj\";")->surface()
    );
    expectSoundSurface(box, 0);
    EXPECT_EQ(box.faces.size(), 12);
    EXPECT_NEAR(surfaceTools::volume(box.points, box.faces), 6, 1e-12);
    rm(file);
}


TEST(surfaceFile, wallOfAVesselIsABoxWithAHole)
{
    const fileName file(fileOf("vessel.obj", boxPoints + boxFaces));
    const string text("type surface; file \"vessel.obj\"; inside yes;");
    const auto wall = shape::New(dictionary(IStringStream(text)()), 3);
    EXPECT_TRUE(wall->hollow());
    const scalar margin = 4*Foam::sqrt(14.0);
    const scalar outer = (3 + margin)*(2 + margin)*(1 + margin);
    EXPECT_NEAR(wall->volume(), outer - 6, 1e-9*outer);
    EXPECT_NEAR(wall->centroid().x(), 1.5, 1e-9);

    const shapeMesh mesh
    (
        newShapeMesh
        (
            dictionary(IStringStream(text)()), 3, 0.25, gradingOf(""), false
        )
    );
    EXPECT_EQ(surfaceTools::nOpenEdges(mesh.faces), 0);
    EXPECT_NEAR
    (
        surfaceTools::volume(mesh.points, mesh.faces), outer - 6, 1e-6*outer
    );
    rm(file);
}


TEST(surfaceFile, sharpEdgesAreKept)
{
    // A wedge of 3 x 4 whose edge has 20 degrees
    const fileName file
    (
        fileOf
        (
            "wedge.obj",
            "v 0 0 0\nv 3 -0.52898 0\nv 3 0.52898 0\n"
            "v 0 0 4\nv 3 -0.52898 4\nv 3 0.52898 4\n"
            "f 1 3 2\nf 4 5 6\nf 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\n"
            "f 3 1 4\nf 3 4 6\n"
        )
    );
    const string text("type surface; file \"wedge.obj\";");
    const shapeMesh wedge(solidOf(text)->surface());
    const scalar area = surfaceTools::area(wedge.points, wedge.faces);
    for (const scalar nodeSpacing : {0.5, 0.4, 0.211})
    {
        const shapeMesh mesh
        (
            newShapeMesh
            (
                dictionary(IStringStream(text)()), 3, nodeSpacing,
                gradingOf(""), false
            )
        );
        EXPECT_EQ(surfaceTools::nOpenEdges(mesh.faces), 0);
        EXPECT_NEAR
        (
            surfaceTools::area(mesh.points, mesh.faces), area, 1e-6*area
        );
    }
    rm(file);
}


// ************************************************************************* //
