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
    // The vessel of the tutorial bifurcation: its branches meet at 25 degrees.
    // Its bends of 17 degrees are no corners, and are cut by a hair
    const fileName file
    (
        fileOf
        (
            "fork.obj",
            "v -0.5 -0.4 0.103\nv 1 -0.4 0.103\nv 3.8 -1.24 0.103\n"
            "v 3.8 -0.51 0.103\nv 1.5 0 0.103\nv 3.8 0.51 0.103\n"
            "v 3.8 1.24 0.103\nv 1 0.4 0.103\nv -0.5 0.4 0.103\n"
            "v -0.5 -0.4 0.897\nv 1 -0.4 0.897\nv 3.8 -1.24 0.897\n"
            "v 3.8 -0.51 0.897\nv 1.5 0 0.897\nv 3.8 0.51 0.897\n"
            "v 3.8 1.24 0.897\nv 1 0.4 0.897\nv -0.5 0.4 0.897\nf 1 8 2\n"
            "f 1 9 8\nf 2 8 5\nf 2 5 3\nf 3 5 4\nf 5 7 6\nf 5 8 7\n"
            "f 10 11 17\nf 10 17 18\nf 11 14 17\nf 11 12 14\nf 12 13 14\n"
            "f 14 15 16\nf 14 16 17\nf 1 2 11\nf 1 11 10\nf 2 3 12\n"
            "f 2 12 11\nf 3 4 13\nf 3 13 12\nf 4 5 14\nf 4 14 13\n"
            "f 5 6 15\nf 5 15 14\nf 6 7 16\nf 6 16 15\nf 7 8 17\n"
            "f 7 17 16\nf 8 9 18\nf 8 18 17\nf 9 1 10\nf 9 10 18\n"
        )
    );
    const string text("type surface; file \"fork.obj\";");
    const shapeMesh fork(solidOf(text)->surface());
    const scalar area = surfaceTools::area(fork.points, fork.faces);
    for (const scalar nodeSpacing : {0.0625, 0.04, 0.03})
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
            surfaceTools::area(mesh.points, mesh.faces), area, 5e-5*area
        );
    }
    rm(file);
}


// ************************************************************************* //
