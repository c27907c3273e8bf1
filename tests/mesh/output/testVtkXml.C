// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "vtkXml.H"
#include <sstream>

using namespace Foam;
using Foam::fsi::vtkXml;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(VtkXml, textHasSixNumbersInALine)
{
    std::ostringstream os;
    vtkXml xml(os, false);
    xml.begin("Points", "a='1'");
    xml.array("Points", vectorField(3, vector(1, 2.5, -0.1)));
    xml.end();
    EXPECT_EQ
    (
        os.str(),
        "<Points a='1'>\n"
        "  <DataArray type='Float32' Name='Points' NumberOfComponents='3'"
        " format='ascii'>\n"
        "1 2.5 -0.100000001 1 2.5 -0.100000001\n"
        "1 2.5 -0.100000001\n"
        "  </DataArray>\n"
        "</Points>\n"
    );
}


TEST(VtkXml, base64BeginsWithTheNumberOfBytes)
{
    // RFC 4648 of the bytes of uint64 4 or 12, and of the numbers
    const std::string n(sizeof(label) == 4 ? "Int32" : "Int64");
    std::ostringstream os;
    vtkXml xml(os, true);
    xml.array("none", labelList());
    xml.array("time", scalarField(1, 0.25));
    xml.array("point", vectorField(1, vector(0, 0, 1)));
    EXPECT_EQ
    (
        os.str(),
        "<DataArray type='" + n + "' Name='none' format='binary'>\n"
        "AAAAAAAAAAA=\n"
        "</DataArray>\n"
        "<DataArray type='Float32' Name='time' format='binary'>\n"
        "BAAAAAAAAAAAAIA+\n"
        "</DataArray>\n"
        "<DataArray type='Float32' Name='point' NumberOfComponents='3'"
        " format='binary'>\n"
        "DAAAAAAAAAAAAAAAAAAAAAAAgD8=\n"
        "</DataArray>\n"
    );
}


TEST(VtkXml, wordsEndWithZeros)
{
    const wordList names({"a", "bc"});
    std::ostringstream text;
    vtkXml(text, false).array("names", names);
    EXPECT_EQ
    (
        text.str(),
        "<Array type='String' Name='names' NumberOfTuples='2'"
        " format='ascii'>\n"
        "97 0 98 99 0\n"
        "</Array>\n"
    );
    std::ostringstream binary;
    vtkXml(binary, true).array("names", names);
    EXPECT_NE(binary.str().find("\nBQAAAAAAAABhAGJjAA==\n"), std::string::npos)
        << binary.str();
}


TEST(VtkXml, valuesBeyondSinglePrecisionAreAtItsEnds)
{
    std::ostringstream os;
    vtkXml xml(os, false);
    scalarField values(2, 1e300);
    values[1] = -1e300;
    xml.array("large", values);
    EXPECT_NE(os.str().find("\n3.40282347e+38 -3.40282347e+38\n"),
              std::string::npos) << os.str();
}


// ************************************************************************* //
