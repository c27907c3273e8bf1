// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "vtkXml.H"
#include <sstream>

using namespace Foam;
using Foam::fsi::vtkXml;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(VtkXml, base64BeginsWithTheNumberOfBytes)
{
    // RFC 4648 of the bytes of uint64 4 or 12, and of the numbers
    const std::string n(sizeof(label) == 4 ? "Int32" : "Int64");
    std::ostringstream os;
    vtkXml xml(os);
    xml.array("none", labelList());
    xml.array("time", scalarField(1, 0.25));
    xml.begin("Points", "a='1'");
    xml.array("point", vectorField(1, vector(0, 0, 1)));
    xml.end();
    EXPECT_EQ
    (
        os.str(),
        "<DataArray type='" + n + "' Name='none' format='binary'>\n"
        "AAAAAAAAAAA=\n"
        "</DataArray>\n"
        "<DataArray type='Float32' Name='time' format='binary'>\n"
        "BAAAAAAAAAAAAIA+\n"
        "</DataArray>\n"
        "<Points a='1'>\n"
        "  <DataArray type='Float32' Name='point' NumberOfComponents='3'"
        " format='binary'>\n"
        "DAAAAAAAAAAAAAAAAAAAAAAAgD8=\n"
        "  </DataArray>\n"
        "</Points>\n"
    );
}


TEST(VtkXml, wordsEndWithZeros)
{
    const wordList names({"a", "bc"});
    std::ostringstream os;
    vtkXml(os).array("names", names);
    EXPECT_EQ
    (
        os.str(),
        "<Array type='String' Name='names' NumberOfTuples='2'"
        " format='binary'>\n"
        "BQAAAAAAAABhAGJjAA==\n"
        "</Array>\n"
    );
}


TEST(VtkXml, valuesBeyondSinglePrecisionAreAtItsEnds)
{
    std::ostringstream os;
    vtkXml xml(os);
    scalarField values(2, 1e300);
    values[1] = -1e300;
    xml.array("large", values);
    // The largest numbers of single precision
    EXPECT_NE(os.str().find("\nCAAAAAAAAAD//39///9//w==\n"), std::string::npos)
        << os.str();
}


// ************************************************************************* //
