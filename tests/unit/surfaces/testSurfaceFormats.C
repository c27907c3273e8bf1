// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes/badShape.H"

#include <cstring>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A box 3 x 2 x 1, in the formats
const std::vector<point> corners
({
    {0, 0, 0}, {0, 0, 1}, {0, 2, 0}, {0, 2, 1},
    {3, 0, 0}, {3, 0, 1}, {3, 2, 0}, {3, 2, 1}
});
const std::vector<std::vector<label>> quads
({
    {1, 2, 4, 3}, {5, 7, 8, 6}, {1, 5, 6, 2},
    {3, 4, 8, 7}, {1, 3, 7, 5}, {2, 6, 8, 4}
});


//- Both triangles of each quad
std::vector<std::vector<label>> triangles()
{
    std::vector<std::vector<label>> result;
    for (const auto& q : quads)
    {
        result.push_back({q[0], q[1], q[2]});
        result.push_back({q[0], q[2], q[3]});
    }
    return result;
}


std::string textOf(const point& p)
{
    std::ostringstream os;
    os << p.x() << ' ' << p.y() << ' ' << p.z();
    return os.str();
}


//- An OBJ whose faces have their labels shifted
std::string obj
(
    const std::vector<std::vector<label>>& faces,
    const label shift = 0,
    const std::string& behind = ""
)
{
    std::string text;
    for (const point& p : corners)
    {
        text += "v " + textOf(p) + '\n';
    }
    for (const auto& f : faces)
    {
        text += "f";
        for (const label l : f)
        {
            text += ' ' + std::to_string(l + shift) + behind;
        }
        text += '\n';
    }
    return text;
}


std::string off()
{
    std::string text("OFF # a box\n8 6 0\n");
    for (const point& p : corners)
    {
        text += textOf(p) + '\n';
    }
    for (const auto& q : quads)
    {
        text += '4';
        for (const label l : q)
        {
            text += ' ' + std::to_string(l - 1);
        }
        text += " 255 0 0\n";
    }
    return text;
}


std::string stl(const std::string& name)
{
    std::string text("solid " + name + '\n');
    for (const auto& t : triangles())
    {
        text += "  facet normal nan 0 0\n    outer loop\n";
        for (const label l : t)
        {
            text += "      vertex " + textOf(corners[l - 1]) + '\n';
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid " + name + '\n';
}


std::string binaryStl(const std::string& title, const std::uint32_t n = 12)
{
    std::string text(title);
    text.resize(80, ' ');
    text.append(reinterpret_cast<const char*>(&n), 4);
    for (const auto& t : triangles())
    {
        std::vector<float> values(3, 0.0f);
        for (const label l : t)
        {
            for (direction d = 0; d < 3; ++d)
            {
                values.push_back(corners[l - 1][d]);
            }
        }
        text.append(reinterpret_cast<const char*>(values.data()), 48);
        text.append(2, '\0');
    }
    return text;
}


std::string replaced
(
    std::string text,
    const std::string& part,
    const std::string& other
)
{
    for
    (
        std::size_t at = text.find(part);
        at != std::string::npos;
        at = text.find(part, at + other.size())
    )
    {
        text.replace(at, part.size(), other);
    }
    return text;
}


//- A file of any name, as long as this object lives
struct writtenFile
{
    const std::string name;

    writtenFile(const std::string& file, const std::string& text)
    :
        name(file)
    {
        std::ofstream(name, std::ios::binary) << text;
    }

    ~writtenFile()
    {
        ::remove(name.c_str());
    }

    std::string entries() const
    {
        return "type surface; file \"" + name + "\";";
    }
};


void expectBox(const std::string& name, const std::string& text)
{
    const writtenFile file(name, text);
    ASSERT_EQ(Foam::fsi::errorOf(file.entries(), 3), "") << text.substr(0, 90);
    const autoPtr<solidShape> body(solidOf(file.entries()));
    EXPECT_NEAR(body->volume(), 6, 1e-12) << name;
    EXPECT_EQ(body->surface().points.size(), 8) << name;
    EXPECT_EQ(body->surface().faces.size(), 12) << name;
}


void expectRefused
(
    const std::string& name,
    const std::string& text,
    const std::vector<std::string>& parts
)
{
    const writtenFile file(name, text);
    const std::string error(Foam::fsi::errorOf(file.entries(), 3));
    EXPECT_NE(error.find(name), std::string::npos) << parts[0];
    for (const std::string& part : parts)
    {
        EXPECT_NE(error.find(part), std::string::npos)
            << part << " in: " << error;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceFormats, readWhatTheyAllow)
{
    expectBox("box.obj", obj(triangles()));
    expectBox("box.obj", obj(quads));
    expectBox("box.obj", obj(quads, -9));
    expectBox("box.obj", "g a\nvn 0 0 1\n" + obj(quads, 0, "//1"));
    expectBox("box.obj", "o a\nvt 0 0\n" + obj(quads, -9, "/1/1"));
    expectBox("box.obj", replaced(obj(quads), "f 1 2", "f 1 \\\n 2"));
    expectBox("box.off", off());
    expectBox("box.off", replaced(off(), "OFF # a box\n", "COFF "));
    expectBox("box.stl", stl("K\xc3\xb6rper 1"));
    expectBox("box.stl", stl(""));
    expectBox("box.STL", replaced(stl("A"), "facet", "FACET"));
    expectBox("box.stl", "\xef\xbb\xbf" + replaced(stl("a"), "\n", "\r\n"));
    expectBox("my k\xc3\xb6rper (1).stl", stl("a"));
    expectBox("box.stl", binaryStl("a box"));
    expectBox("box.stlb", binaryStl("solid as SolidWorks has it"));

    // The parts in solids of their own, and a triangle that comes twice
    const std::string half(replaced(stl("a"), "endsolid a\n", ""));
    const std::size_t middle = half.find("facet", half.size()/2);
    expectBox
    (
        "box.stl",
        half.substr(0, middle) + "endsolid a\nsolid b\n  "
      + half.substr(middle) + "endsolid\n"
      + half.substr(0, half.find("endfacet")) + "endfacet\nendsolid a\n"
    );
}


TEST(surfaceFormats, nameLineAndFault)
{
    expectRefused
    (
        "a.obj", replaced(obj(quads), "f 1 2 ", "f 1 22 "),
        {"line 9", "the 8 points"}
    );
    expectRefused
    (
        "a.obj", replaced(obj(quads), "f 1 2 ", "f 1 -22 "),
        {"line 9", "corner -22"}
    );
    expectRefused
    (
        "a.obj", replaced(obj(quads), "v 3 2 1", "v 3 nan 1"),
        {"line 8", "'nan'", "1e15"}
    );
    expectRefused
    (
        "a.obj", replaced(obj(quads), "f 1 2 4 3", "f 1 2"),
        {"line 9", "less than three"}
    );
    expectRefused
    (
        "a.off", replaced(off(), "4 0 1 3 2", "4 0 1 3 8"),
        {"line 11", "the 8 points"}
    );
    expectRefused
    (
        "a.off", replaced(off(), "8 6 0", "8 2000000000 0"),
        {"line 16", "promises more faces"}
    );
    expectRefused
    (
        "a.off", replaced(off(), "8 6 0", "99999999999 6 0"),
        {"line 2", "'99999999999'"}
    );
    expectRefused
    (
        "a.stl", replaced(stl("a"), "3 2 1\n", "3 2 1e400\n"),
        {"line", "'1e400'"}
    );
    expectRefused
    (
        "a.stl", stl("a").substr(0, 300), {"line", "within a triangle"}
    );
    expectRefused("a.stl", replaced(stl("a"), "loop", "lop"), {"line 3"});
    expectRefused("a.stl", binaryStl("a", 0), {"0 triangles", "as for 12"});
    expectRefused
    (
        "a.stl", binaryStl("solid", 4000000000u), {"4000000000 triangles"}
    );
    expectRefused("a.stl", binaryStl("a").substr(0, 300), {"300 bytes"});
    expectRefused("a.stl", "", {"empty"});
    expectRefused("a.vtk", "# vtk", {"valid formats", "surfaceConvert"});
}


// ************************************************************************* //
