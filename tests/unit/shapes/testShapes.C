// SPDX-License-Identifier: GPL-3.0-or-later

#include "outlineTools.H"
#include "badShape.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include "polygonPredicates.H"

#include <cstdlib>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Shapes that together use every type
const string circle("type circle; radius 0.1;");
const string ellipse("type ellipse; semiAxes (0.2 0.1);");
const string star("type star; radius 0.1; amplitude 0.3; points 5;");
const string biconcave("type biconcave; radius 3.91;");
const string rod("type rectangle; length 0.4; width 0.1; edgeRadius 0.05;");

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(shape, outlineIsUniformClosedAndCounterClockwise)
{
    for (const string& text : {circle, ellipse, star, biconcave, rod})
    {
        const autoPtr<planarShape> body(shapeOf(text));
        const pointField fine(body->curve());
        const scalar h = outlineTools::perimeter(fine)/100;
        const pointField points(body->outline(h));

        EXPECT_EQ(points.size(), 100) << text;
        EXPECT_NEAR(outlineTools::area(points), outlineTools::area(fine), 1e-9);
        EXPECT_TRUE(polygonPredicates::isSimple(points));
        EXPECT_LT(mag(outlineTools::centroid(points)), 1e-12*h*100);
        EXPECT_EQ(max(mag(points.component(vector::Z))), 0);

        // Chords of equal arcs differ where the curvature does
        forAll(points, i)
        {
            const scalar chord = mag(points[points.fcIndex(i)] - points[i]);
            EXPECT_LT(chord, 1.002*h);
            EXPECT_GT(chord, 0.94*h) << text << " node " << i;
        }
    }
}


TEST(shape, circleIsARegularPolygonOfItsArea)
{
    const pointField points(shapeOf(circle)->outline(0.01));
    EXPECT_EQ(points.size(), 63);
    const scalar angle = constant::mathematical::twoPi/63;
    for (const point& p : points)
    {
        EXPECT_NEAR(mag(p), 0.1*std::sqrt(angle/std::sin(angle)), 1e-8);
    }
}


TEST(shape, biconcaveIsEvansAndFungs)
{
    // The body of revolution has 94.10 um3 and 134.09 um2, its section is
    // 0.810 um thin in the middle and 2.566 um at most
    const pointField points(shapeOf(biconcave)->outline(0.05));
    scalar volume = 0, area = 0, thickest = 0, middle = GREAT;
    forAll(points, i)
    {
        const point& a = points[i];
        const point& b = points[points.fcIndex(i)];
        if (a.x() > 0 || b.x() > 0)
        {
            const scalar r = 0.5*(mag(a.x()) + mag(b.x()));
            volume += constant::mathematical::twoPi*r
               *0.5*(a.y() + b.y())*(a.x() - b.x());
            area += constant::mathematical::twoPi*r*mag(b - a);
        }
        thickest = max(thickest, 2*mag(a.y()));
        if (mag(a.x()) < 0.1)
        {
            middle = min(middle, 2*mag(a.y()));
        }
    }
    EXPECT_NEAR(volume, 94.10, 0.005*94.10);
    EXPECT_NEAR(area, 134.09, 0.005*134.09);
    EXPECT_NEAR(thickest, 2.566, 0.005*2.566);
    EXPECT_NEAR(middle, 0.810, 0.005*0.810);
}


TEST(shape, minimumThicknessIsThatOfTheNeck)
{
    EXPECT_NEAR(shapeOf(circle)->minimumThickness(), 0.2, 1e-3);
    EXPECT_NEAR(shapeOf(ellipse)->minimumThickness(), 0.2, 5e-3);
    EXPECT_NEAR(shapeOf(biconcave)->minimumThickness(), 0.810, 0.01);

    // The shortest way between two valleys that are not neighbours
    const auto valley = [](const scalar turn)
    {
        const scalar r = 0.1*(1 + 0.3*std::cos(5*turn));
        return point(r*std::cos(turn), r*std::sin(turn), 0);
    };
    scalar neck = GREAT;
    for (scalar a = -0.2; a < 0.2; a += 1e-3)
    {
        const point p(valley(constant::mathematical::pi/5 + a));
        const point q(valley(constant::mathematical::pi - a));
        neck = min(neck, mag(p - q));
    }
    EXPECT_NEAR(shapeOf(star)->minimumThickness(), neck, 0.01*neck);
}


TEST(shape, neckBetweenTwoNotchesIsThin)
{
    const auto thickness = [](const string& points)
    {
        const fileName csv(fileOf("neck.csv", points));
        const scalar result =
            shapeOf("type polygon; file \"neck.csv\";")->minimumThickness();
        rm(csv);
        return result;
    };

    // A bow tie; its neck as thin as one likes
    for (const string half : {"1e-3", "1e-12"})
    {
        const string tie
        (
            "-0.2,-0.1\n0,-" + half + "\n0.2,-0.1\n0.2,0.1\n0," + half
          + "\n-0.2,0.1\n"
        );
        const scalar width = 2*std::stod(half);
        EXPECT_NEAR(thickness(tie), width, 1e-3*width);
    }

    // Notches that are not across each other
    EXPECT_NEAR
    (
        thickness("-2,-1\n0,0\n2,-1\n2,1.5\n0.1,0.4\n-2,2\n"),
        std::hypot(0.1, 0.4),
        1e-9
    );

    // Below a slit, in the arms of an L, but not in a corner
    EXPECT_NEAR
    (
        thickness("0,0\n1,0\n1,1\n0.51,1\n0.5,0.2\n0.49,1\n0,1\n"),
        0.2,
        1e-9
    );
    EXPECT_NEAR
    (
        thickness("0,0\n1,0\n1,0.2\n0.3,0.2\n0.3,1\n0,1\n"), 0.2, 1e-9
    );
    EXPECT_GT(thickness("0,0\n1,0\n0,0.4\n"), 0.2);
}


TEST(shape, polygonKeepsItsCornersAndIsTurnedRound)
{
    // Clockwise, closed twice, a point repeated, with comments and a heading
    const string start("\xef\xbb\xbf# square\nx, y\n0,0\n0,1\n# corner\n");
    const string end("1.5,1\n1.5,1\n1.5,0\n\n0,0\n");
    const fileName csv(fileOf("square.csv", start + end));
    const fileName list
    (
        fileOf("square.list", "4 ((0 0 0) (1.5 0 0) (1.5 1 0) (0 1 0))")
    );
    for (const fileName& file : {csv, list})
    {
        const autoPtr<planarShape> body
        (
            shapeOf("type polygon; file \"" + file + "\"; scale 2;")
        );
        const pointField points(body->outline(0.3));
        EXPECT_NEAR(outlineTools::area(points), 6, 1e-12);
        EXPECT_EQ(points.size(), 2*(10 + 7));
        EXPECT_NEAR(body->minimumThickness(), 2, 1e-9);

        label nCorners = 0;
        for (const point& p : points)
        {
            nCorners +=
                mag(mag(p.x()) - 1.5) < 1e-12 && mag(mag(p.y()) - 1) < 1e-12;
        }
        EXPECT_EQ(nCorners, 4);
    }

    // A relative name starts at the case
    setEnv("FOAM_CASE", csv.path(), true);
    EXPECT_EQ
    (
        shapeOf("type polygon; file \"" + csv.name() + "\";")->curve().size(),
        4
    );
    EXPECT_EQ
    (
        shapeOf("type polygon; file \"<case>/" + csv.name() + "\";")
            ->curve().size(),
        4
    );
    ::unsetenv("FOAM_CASE");
    rm(csv);
    rm(list);
}


TEST(badShape, isRefusedWithFileAndKey)
{
    expectError("type blob;", {"type", "blob", "circle", "polygon"});
    expectError("type circle; radius -1;", {"radius"});
    expectError("type circle; radius 1; colour 2;", {"colour"});
    expectError("type ellipse; semiAxes (1 0);", {"semiAxes"});
    expectError("type star; radius 1; amplitude 1;", {"amplitude"});
    expectError("type star; radius 1; points 1;", {"points"});
    expectError("type biconcave;", {"radius"});
    expectError("type rectangle; length 1;", {"width"});
    expectError
    (
        "type rectangle; length 1; width 2; edgeRadius 0.51;", {"edgeRadius"}
    );
    expectError(circle, {"type", "circle", "sphere", "surface"}, 3);
    EXPECT_EQ(errorOf(circle, 2), "");
}


TEST(badShape, polygonThatCannotBeUsedIsRefused)
{
    const string polygon("type polygon; file ");
    expectError(polygon + "\"missing.csv\";", {"file", "missing.csv"});

    const fileName bow(fileOf("bow.csv", "0,0\n1,1\n1,0\n0,1\n"));
    expectError(polygon + "\"bow.csv\";", {"file", "crosses"});
    rm(bow);

    const fileName two(fileOf("two.csv", "0,0\n1,1\n"));
    expectError(polygon + "\"two.csv\";", {"file", "two.csv"});
    rm(two);

    const fileName broken(fileOf("broken.csv", "0,0\n1,0\n1;1\n0,1\n"));
    expectError(polygon + "\"broken.csv\";", {"file", "line 3"});
    rm(broken);

    // Not taken for headings, and not for points
    for (const string& first : {"O,0", "nan,0", "0,inf", "0,0;1"})
    {
        const fileName typo(fileOf("typo.csv", first + "\n1,0\n1,1\n0,1\n"));
        expectError(polygon + "\"typo.csv\";", {"file", "line 1"});
        rm(typo);
    }

    const fileName text(fileOf("text.list", "no points here"));
    EXPECT_NE(errorOf(polygon + "\"text.list\";", 2), "");
    rm(text);
}


// ************************************************************************* //
