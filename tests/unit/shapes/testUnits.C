// SPDX-License-Identifier: GPL-3.0-or-later

#include "badShape.H"
#include "newShapeMesh.H"
#include "OSspecific.H"

#include <vector>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Dictionaries of shapes whose lengths are in a unit, as a user writes them;
//  the last one is of a box in a file
std::vector<string> shapesIn(const scalar unit)
{
    const auto length = [&](const scalar x)
    {
        return ' ' + string(Foam::name(unit*x));
    };
    string box;
    for (label i = 0; i < 8; ++i)
    {
        box += "v" + length(0.31*(i/4)) + length(0.17*(i/2 % 2))
          + length(0.13*(i % 2)) + '\n';
    }
    box +=
        "f 1 2 4\nf 1 4 3\nf 5 7 8\nf 5 8 6\nf 1 5 6\nf 1 6 2\n"
        "f 3 4 8\nf 3 8 7\nf 1 3 7\nf 1 7 5\nf 2 6 8\nf 2 8 4\n";
    const fileName file(fileOf("box.obj", box));
    return
    {
        "type sphere; radius" + length(0.1) + ';',
        "type ellipsoid; semiAxes (" + length(0.2) + length(0.1) + length(0.1)
      + ");",
        "type torus; radius" + length(0.1) + "; tubeRadius" + length(0.04)
      + ';',
        "type biconcave; radius" + length(0.2) + ';',
        "type cylinder; radius" + length(0.1) + "; length" + length(0.3)
      + "; edgeRadius" + length(0.05) + ';',
        "type box; size (" + length(0.2) + length(0.1) + length(0.1) + ");",
        "type surface; file \"" + file + "\";"
    };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solid, meshIsTheSameInAllUnits)
{
    std::vector<shapeMesh> inMetres;
    for (const scalar unit : {1.0, 1e-3, 1e6})
    {
        const std::vector<string> texts(shapesIn(unit));
        for (std::size_t i = 0; i < texts.size(); ++i)
        {
            IStringStream is(texts[i]);
            const shapeMesh mesh
            (
                newShapeMesh
                (
                    dictionary(is), 3, unit*0.03, gradingOf(""), true
                )
            );
            if (unit == 1)
            {
                inMetres.push_back(mesh);
            }
            const shapeMesh& first = inMetres[i];
            ASSERT_EQ(mesh.points.size(), first.points.size()) << texts[i];
            EXPECT_EQ(mesh.elements, first.elements) << texts[i];
            EXPECT_LT(max(mag(mesh.points/unit - first.points)), 1e-13);
        }
    }
    rm("box.obj");
}


// ************************************************************************* //
