// SPDX-License-Identifier: GPL-3.0-or-later

#include "innerNodes.H"
#include "outlineTools.H"
#include "shapeOf.H"
#include "OSspecific.H"

#include <fstream>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(triangulation, fillsTheOutlineWithGoodTriangles)
{
    for
    (
        const string text :
        {
            "type circle; radius 0.1;",
            "type ellipse; semiAxes (0.2 0.1);",
            "type star; radius 0.1; amplitude 0.3; points 5;",
            "type biconcave; radius 3.91;"
        }
    )
    {
        const autoPtr<planarShape> body(shapeOf(text));
        const scalar h = body->minimumThickness()/6;
        const shapeMesh mesh(body->mesh(h, gradingOf(""), true));
        const pointField outline(body->outline(h));

        // The boundary nodes are the given ones, and no side is divided
        ASSERT_EQ(mesh.nBoundary, outline.size());
        ASSERT_EQ(mesh.faces.size(), outline.size());
        forAll(outline, i)
        {
            EXPECT_EQ(mesh.points[i], outline[i]);
            EXPECT_EQ(mesh.faces[i][0], i);
            EXPECT_EQ(mesh.faces[i][1], outline.fcIndex(i));
        }

        const scalarField volumes(mesh.elementVolumes());
        const scalar area = outlineTools::area(outline);
        EXPECT_GT(min(volumes), 0.1*average(volumes)) << text;
        EXPECT_NEAR(sum(volumes), area, 1e-12*area);
        EXPECT_GT(mesh.smallestAngle(), 28) << text;

        // Euler: nodes - edges + elements = 1 without holes or loose nodes
        EXPECT_EQ
        (
            mesh.points.size() - mesh.edges().size() + mesh.elements.size(), 1
        );
    }
}


TEST(triangulation, straightSlantedSidesHaveNoFlatTriangles)
{
    // Nodes between corners are in line up to rounding, on either side of it
    const fileName csv("wedge.csv");
    std::ofstream(csv) << "0.8,0\n2.2,0\n1.7,0.37\n1.4,0.37\n";
    for (const scalar h : {0.06, 0.03, 0.02})
    {
        const string text("type polygon; file \"" + csv + "\";");
        const shapeMesh mesh(shapeOf(text)->mesh(h, gradingOf(""), true));
        const scalarField volumes(mesh.elementVolumes());
        EXPECT_GT(min(volumes), 0.1*average(volumes)) << h;
        EXPECT_NEAR(sum(volumes), 0.5*(1.4 + 0.3)*0.37, 1e-12);
    }
    rm(csv);
}


TEST(triangulation, deepNodesAreSparseAndTrianglesGood)
{
    const string large("type circle; radius 30;");
    const string notched("type star; radius 30; amplitude 0.25; points 5;");
    const meshGrading even(gradingOf("growthRate 0;"));
    for (const string& text : {large, notched})
    {
        const autoPtr<planarShape> body(shapeOf(text));
        const shapeMesh all(body->mesh(1, even, true));
        const shapeMesh mesh(body->mesh(1, gradingOf(""), true));
        const scalarField volumes(mesh.elementVolumes());
        const scalar area = outlineTools::area(body->outline(1));
        EXPECT_NEAR(sum(volumes), area, 1e-12*area);
        EXPECT_LT(mesh.points.size(), 0.7*all.points.size()) << text;
        EXPECT_GT(mesh.smallestAngle(), 28) << text;

        // Each edge near the size that its middle wants
        const pointField outline(body->outline(1));
        const meshGrading grading(gradingOf(""));
        scalar least = GREAT, most = 0;
        for (const edge& e : mesh.edges())
        {
            const scalar wanted = grading.size
            (
                outlineTools::distance(outline, e.centre(mesh.points))
            );
            least = min(least, e.mag(mesh.points)/wanted);
            most = max(most, e.mag(mesh.points)/wanted);
        }
        EXPECT_GT(least, 0.5) << text;
        EXPECT_LT(most, 1.8) << text;
        std::cout
            << all.points.size() << " even, " << mesh.points.size()
            << " graded nodes, smallest angle " << mesh.smallestAngle()
            << ", edges " << least << " to " << most << std::endl;
    }

    // Nothing changes in bodies that are nowhere deeper than evenDepth
    const autoPtr<planarShape> small(shapeOf("type circle; radius 6;"));
    EXPECT_EQ
    (
        small->mesh(1, even, true).points,
        small->mesh(1, gradingOf(""), true).points
    );
}


TEST(triangulation, innerNodesKeepOffTheSurface)
{
    const pointField outline(shapeOf("type circle; radius 12;")->outline(1));
    for (const string text : {"growthRate 0;", "", "evenDepth 0;"})
    {
        const meshGrading grading(gradingOf(text));
        const innerNodes inner(outline, 1, grading, 0.6, Zero);
        ASSERT_GT(inner.points().size(), 0) << text;
        for (const point& p : inner.points())
        {
            EXPECT_TRUE(outlineTools::contains(outline, p)) << text;
            EXPECT_GT(outlineTools::distance(outline, p), 0.6) << text;
        }
    }
}


// ************************************************************************* //
