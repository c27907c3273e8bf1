// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/badShape.H"
#include "mathematicalConstants.H"
#include "newShapeMesh.H"
#include "outlineTools.H"
#include "shapes/soundMesh.H"
#include "unitConversion.H"

using namespace Foam;
using namespace Foam::fsi;
using constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A shape, its volume and area, number of holes and least thickness
struct solidSample
{
    string text;
    scalar volume;
    scalar area;
    label nHoles;
    scalar thickness;
};


//- Area of the ellipsoid of semi-axes 0.2, 0.1, 0.1
scalar prolateArea()
{
    const scalar e = std::sqrt(0.75);
    return constant::mathematical::twoPi*0.01*(1 + 2/e*std::asin(e));
}


//- Volume of a cylinder with round edges by Pappus' theorem: the section is a
//  rectangle and, at the outside, one less wide and two quarters of a circle
scalar coinVolume(const scalar R, const scalar L, const scalar r)
{
    const scalar a = R - r;
    return
        pi*sqr(a)*L
      + constant::mathematical::twoPi
       *((a + 0.5*r)*r*(L - 2*r) + (a + 4*r/(3*pi))*0.5*pi*sqr(r));
}


scalar coinArea(const scalar R, const scalar L, const scalar r)
{
    const scalar a = R - r;
    return
        2*pi*sqr(a) + 2*pi*R*(L - 2*r)
      + constant::mathematical::twoPi*(a + 2*r/pi)*pi*r;
}


//- Shapes whose size is known in closed form, or from Evans and Fung
const solidSample samples[] =
{
    {"type sphere; radius 0.1;", 4e-3/3*pi, 4e-2*pi, 0, 0.2},
    {
        "type ellipsoid; semiAxes (0.2 0.1 0.1);",
        8e-3/3*pi, prolateArea(), 0, 0.2
    },
    {
        "type torus; radius 0.1; tubeRadius 0.04;",
        2*pi*pi*0.1*0.0016, 4*pi*pi*0.1*0.04, 1, 0.08
    },
    {"type biconcave; radius 3.91;", 94.10, 134.09, 0, 0.810},
    {
        "type cylinder; radius 0.1; length 0.4;",
        4e-3*pi, 0.1*pi, 0, 0.2
    },
    {
        "type cylinder; radius 0.1; length 0.4; edgeRadius 0.1;",
        2e-3*pi + 4e-3/3*pi, 0.08*pi, 0, 0.2
    },
    {
        "type cylinder; radius 0.2; length 0.1; edgeRadius 0.03;",
        coinVolume(0.2, 0.1, 0.03), coinArea(0.2, 0.1, 0.03), 0, 0.1
    },
    {"type box; size (0.4 0.2 0.3);", 0.024, 0.52, 0, 0.2}
};

const string star("type star; radius 0.1; amplitude 0.3; points 5;");


shapeMesh meshOf
(
    const string& text,
    const scalar h,
    const bool filled = true,
    const string& grading = ""
)
{
    IStringStream is(text);
    return newShapeMesh(dictionary(is), 3, h, gradingOf(grading), filled);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solid, surfacesHaveTheSizeOfTheShape)
{
    for (const solidSample& s : samples)
    {
        const autoPtr<solidShape> body(solidOf(s.text));
        const shapeMesh fine(body->surface());
        expectSoundSurface(fine, s.nHoles);

        // Four digits are known of the red cell
        EXPECT_NEAR(body->volume(), s.volume, 1e-4*s.volume) << s.text;
        EXPECT_NEAR
        (
            surfaceTools::volume(fine.points, fine.faces),
            s.volume,
            2e-3*s.volume
        );
        EXPECT_NEAR
        (
            surfaceTools::area(fine.points, fine.faces),
            s.area,
            2e-3*s.area
        );

        // The chord of two faces that are inclined by 15 degrees counts
        EXPECT_NEAR
        (
            body->minimumThickness(),
            s.thickness,
            (1 - std::cos(degToRad(15.0)))*s.thickness
        );
    }

    const autoPtr<solidShape> body(solidOf(star));
    const shapeMesh fine(body->surface());
    EXPECT_NEAR
    (
        surfaceTools::volume(fine.points, fine.faces),
        body->volume(),
        2e-3*body->volume()
    );
}


TEST(solid, sectionIsTheOutlineOfTwoDimensions)
{
    for (const string& text : {samples[3].text, star})
    {
        const pointField outline(shapeOf(text)->outline(1e-3));
        const scalar size = boundBox(outline, false).span().x();
        label nInPlane = 0;
        for (const point& p : solidOf(text)->surface().points)
        {
            if (mag(p.z()) < 1e-9*size)
            {
                EXPECT_LT(outlineTools::distance(outline, p), 1e-4*size);
                ++nInPlane;
            }
        }
        EXPECT_GT(nInPlane, 20) << text;
    }
}


TEST(solid, meshesAreSoundAndOfTheShapesVolume)
{
    for (const solidSample& s : samples)
    {
        const scalar h = s.thickness/(s.nHoles ? 5 : s.volume > 1 ? 2 : 8);
        const shapeMesh mesh(meshOf(s.text, h));
        expectSoundSurface(mesh, s.nHoles);
        expectSoundFilling(mesh, s.nHoles);

        const scalar volume = solidOf(s.text)->volume();
        EXPECT_NEAR(sum(mesh.elementVolumes()), volume, 1e-12*volume);
        EXPECT_NEAR
        (
            surfaceTools::volume(mesh.points, mesh.faces), volume, 1e-12*volume
        );
        EXPECT_LT
        (
            mag(surfaceTools::centroid(mesh.points, mesh.faces)), 1e-10*h
        );
        EXPECT_NEAR
        (
            surfaceTools::area(mesh.points, mesh.faces), s.area, 0.02*s.area
        ) << s.text;

        const auto edges = lengths(mesh.edges(), mesh.points);
        EXPECT_NEAR(edges[0], h, 0.1*h) << s.text;
        EXPECT_GT(edges[1], 0.3*h) << s.text;
        EXPECT_LT(edges[2], 2*h) << s.text;
        std::cout
            << s.text << ": " << mesh.points.size() << " nodes, "
            << mesh.nBoundary << " on the surface, " << mesh.elements.size()
            << " tetrahedra, smallest dihedral angle " << mesh.smallestAngle()
            << ", edges over h " << edges[0]/h << " (" << edges[1]/h << " to "
            << edges[2]/h << ")" << std::endl;
    }
}


TEST(solid, meshIsTheSameOnEachRun)
{
    const shapeMesh first(meshOf(star, 0.03));
    meshOf(samples[0].text, 0.05);
    const shapeMesh second(meshOf(star, 0.03));
    EXPECT_EQ(first.points, second.points);
    EXPECT_EQ(first.faces, second.faces);
    EXPECT_EQ(first.elements, second.elements);
}


TEST(solid, surfaceAloneHasNoElements)
{
    for (const solidSample& s : samples)
    {
        const scalar h = s.thickness/(s.nHoles ? 5 : s.volume > 1 ? 2 : 8);
        const shapeMesh mesh(meshOf(s.text, h, false));
        EXPECT_EQ(mesh.elements.size(), 0);
        EXPECT_EQ(mesh.points.size(), mesh.nBoundary);
        EXPECT_EQ(mesh.nDims(), 3);
        expectSoundSurface(mesh, s.nHoles);

        const scalar volume = solidOf(s.text)->volume();
        EXPECT_NEAR
        (
            surfaceTools::volume(mesh.points, mesh.faces), volume, 1e-12*volume
        );
        scalar sum = 0;
        const auto edges = surfaceEdges(mesh);
        for (const auto& e : edges)
        {
            sum += mag(mesh.points[e.first] - mesh.points[e.second]);
        }
        EXPECT_NEAR(sum/edges.size(), h, 0.15*h) << s.text;
    }

    IStringStream is("type circle; radius 0.1;");
    const shapeMesh ring
    (
        newShapeMesh(dictionary(is), 2, 0.01, gradingOf(""), false)
    );
    EXPECT_EQ(ring.elements.size(), 0);
    EXPECT_EQ(ring.points, shapeOf("type circle; radius 0.1;")->outline(0.01));
    EXPECT_EQ(ring.nBoundary, ring.points.size());
    EXPECT_EQ(ring.faces.size(), ring.points.size());
}


TEST(solid, deepNodesAreSparse)
{
    const string text("type sphere; radius 6;");
    const shapeMesh even(meshOf(text, 1, true, "growthRate 0;"));
    const shapeMesh graded(meshOf(text, 1, true, "evenDepth 1;"));
    expectSoundSurface(graded, 0);
    expectSoundFilling(graded, 0);
    EXPECT_LT(graded.points.size(), 0.85*even.points.size());
    EXPECT_NEAR(graded.nBoundary, even.nBoundary, 0.1*even.nBoundary);
}


TEST(badShape, solidsAreRefusedWithFileAndKey)
{
    expectError("type blob;", {"type", "blob", "sphere", "surface"}, 3);
    expectError("type sphere; radius 1;", {"type", "circle", "polygon"}, 2);
    expectError("type sphere; radius -1;", {"radius"}, 3);
    expectError("type sphere; radius 1; colour 2;", {"colour"}, 3);
    expectError("type ellipsoid; semiAxes (1 1 0);", {"semiAxes"}, 3);
    expectError("type torus; radius 1; tubeRadius 1;", {"tubeRadius"}, 3);
    expectError("type star; radius 1; points 1;", {"points"}, 3);
    expectError("type biconcave;", {"radius"}, 3);
    expectError("type box; size (1 1 0);", {"size"}, 3);
    expectError
    (
        "type cylinder; radius 1; length 3; edgeRadius 1.1;",
        {"edgeRadius"},
        3
    );
    expectError("type cylinder; radius 1; width 2;", {"width", "radius"}, 3);

    // A sphere in millimetres
    try
    {
        meshOf("type sphere; radius 50;", 2e-3);
        ADD_FAILURE();
    }
    catch (const Foam::IOerror& error)
    {
        EXPECT_NE(error.message().find("millimetres"), string::npos);
    }
}


// ************************************************************************* //
