// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/samples.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "samples/newShapeTemplate.H"

#include <fstream>
#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const fileName path("badInputDict");


//- The error that a template made from a file with this text gives, or an
//  empty text
string errorOf(const string& shape, const string& material, const string& admm)
{
    {
        std::ofstream os(path);
        os << "shape { " << shape << " } material { " << material
           << " } admm { " << admm << " }\n";
    }
    string text;
    try
    {
        IFstream is(path);
        const dictionary dict(is);
        newShapeTemplate("body", dict, 0.03, 1, 2);
    }
    catch (const Foam::IOerror& error)
    {
        OStringStream os;
        os << error;
        text = os.str();
    }
    rm(path);
    return text;
}


//- The error names the file and the words
void expectError(const string& error, const wordList& words)
{
    EXPECT_NE(error.find(path), string::npos) << error;
    for (const word& w : words)
    {
        EXPECT_NE(error.find(w), string::npos) << w << " in: " << error;
    }
}

const string circle("type circle; radius 0.1;");
const string rubber("density 1000; E 1e4;");

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(badMaterial, isRefusedWithFileAndKey)
{
    EXPECT_EQ(errorOf(circle, rubber, ""), "");

    expectError(errorOf(circle, "density -1; E 1e4;", ""), {"density", "-1"});
    expectError(errorOf(circle, "density 1000; E 0;", ""), {"'E'"});
    expectError(errorOf(circle, "density 1000;", ""), {"E"});
    expectError
    (
        errorOf(circle, rubber + "areaStiffness -2;", ""),
        {"areaStiffness"}
    );
    expectError(errorOf(circle, rubber + "colour 3;", ""), {"colour"});
    expectError
    (
        errorOf(circle, rubber + "type rubber;", ""),
        {"type", "elastic", "neoHookean", "membrane"}
    );
    expectError
    (
        errorOf
        (
            circle, rubber + "type neoHookean; areaStiffness 5e3;", ""
        ),
        {"areaStiffness", "5000"}
    );
    expectError
    (
        errorOf(circle, rubber + "type neoHookean; springLaw {}", ""),
        {"springLaw"}
    );
    expectError
    (
        errorOf(circle, rubber + "springLaw { type Burgers; }", ""),
        {"type", "Burgers", "Hookean", "KelvinVoigt", "Maxwell"}
    );
    expectError
    (
        errorOf(circle, rubber + "springLaw { type Maxwell; }", ""),
        {"viscosity"}
    );
    expectError
    (
        errorOf
        (
            circle, rubber + "springLaw { type Maxwell; viscosity 0; }", ""
        ),
        {"viscosity"}
    );
    expectError
    (
        errorOf(circle, rubber + "calibration guess;", ""),
        {"calibration", "patch", "vanGelder"}
    );
}


TEST(badMaterial, namesTheDomainsOfTheStrain)
{
    expectError
    (
        errorOf(circle, rubber + "strain linear;", ""),
        {"strain", "linear", "triangle", "smoothed"}
    );
}


TEST(badMaterial, withBadViscosityIsRefused)
{
    expectError(errorOf(circle, rubber + "viscosity -1;", ""), {"viscosity"});
    expectError
    (
        errorOf(circle, rubber + "viscosity 1; areaStiffness 0;", ""),
        {"viscosity", "areaStiffness"}
    );
}


TEST(badSolver, isRefusedWithFileAndKey)
{
    expectError(errorOf(circle, rubber, "iterations 0;"), {"iterations"});
    expectError(errorOf(circle, rubber, "tolerance -1;"), {"tolerance"});
    expectError(errorOf(circle, rubber, "areaWeight 0;"), {"areaWeight"});
    expectError(errorOf(circle, rubber, "rotation on;"), {"rotation"});
    expectError(errorOf(circle, rubber, "iteration 5;"), {"iteration"});
}


TEST(badMotion, isRefused)
{
    auto shape = disc(rubber, "", 0.04);
    for
    (
        const string motion :
        {
            "type jumping;",
            "type free; velocity (1 0 0);",
            "type translating;",
            "type oscillating; amplitude (1 0 0); frequency -1;",
            "type rotating; angularVelocity (0 0 1); speed 2;"
        }
    )
    {
        EXPECT_THROW
        (
            bodyGroup::New(*shape, dictionaryOf(motion)), Foam::IOerror
        )
            << motion;
    }
}


TEST(badTimeStep, isRefused)
{
    auto shape = disc(rubber, "", 0.04);
    EXPECT_THROW(shape->factor(0), Foam::error);
    EXPECT_THROW(shape->factor(-1e-3), Foam::error);
    EXPECT_THROW(shape->factor(std::nan("")), Foam::error);
}


TEST(badMesh, withAnInvertedElementIsRefused)
{
    shapeMesh mesh(latticeBar(3, 2, 0.1));
    std::swap(mesh.elements[0][0], mesh.elements[0][1]);
    EXPECT_THROW(bodyOf(mesh, 0.1, rubber), Foam::error);
}


TEST(badMembrane, isRefusedWithFileAndKey)
{
    const string good("type membrane; density 1000; shearModulus 1;");
    const auto errorIn = [](const string& material)
    {
        return errorOf(circle, material, "");
    };

    // errorOf() writes an entry `admm`, which is looked at last
    expectError(errorIn(good), {"admm", "membrane"});
    expectError(errorIn("type gum; density 1;"), {"gum", "membrane"});
    expectError(errorIn(good + "E 1e4;"), {"E", "shearModulus"});
    expectError(errorIn(good + "innerViscosity -1;"), {"innerViscosity"});
    expectError(errorIn(good + "bendingModulus -1;"), {"bendingModulus"});
    expectError
    (
        errorIn(good + "restCurvature 0;"),
        {"'0'", "restCurvature", "shape", "flat"}
    );
    expectError(errorIn(good + "law 2;"), {"law", "2", "Skalak", "drop"});
    expectError
    (
        errorIn("type membrane; density 1; stretchingModulus 1;"),
        {"stretchingModulus", "shearModulus", "areaModulus"}
    );
}


// ************************************************************************* //
