// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFormats.H"
#include "errorOf.H"
#include "textLines.H"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace surfaceFormats
{

//- Bytes of a binary file: before the number of triangles, before the
//  triangles, and of each
static const std::size_t titleSize = 80, headSize = 84, triangleSize = 50;


//- The number of triangles that a binary file says it has
static std::uint32_t countOf(const std::string& text)
{
    std::uint32_t n = 0;
    std::memcpy(&n, text.data() + titleSize, sizeof(n));
    return n;
}


//- Has the file just as many bytes as a binary one of its number of triangles?
static bool fitsBinary(const std::string& text)
{
    return
        text.size() >= headSize
     && text.size() - headSize == triangleSize*std::size_t(countOf(text));
}


//- Append a triangle of three points
static void appendTriangle
(
    polygonSoup& soup,
    const point* corners,
    const label place
)
{
    const label n = soup.points.size();
    soup.points.insert(soup.points.end(), corners, corners + 3);
    soup.append({n, n + 1, n + 2}, place);
}


static polygonSoup readBinary(const std::string& text)
{
    if (!fitsBinary(text))
    {
        const bool head = text.size() >= headSize;
        throw std::runtime_error
        (
            "it is neither an STL file of text, which begins with 'solid', nor"
            " has it the size of a binary one: its head says "
          + (head ? std::to_string(countOf(text)) : std::string("no number of"))
          + " triangles, and there are "
          + std::to_string(text.size()) + " bytes, as for "
          + std::to_string(head ? (text.size() - headSize)/triangleSize : 0)
        );
    }
    polygonSoup soup;
    soup.unit = "triangle";
    soup.floats = true;
    for (std::uint32_t i = 0; i < countOf(text); ++i)
    {
        // Behind the normal, little-endian as all machines that OpenFOAM runs
        // on
        float values[9];
        std::memcpy
        (
            values,
            text.data() + headSize + triangleSize*i + 3*sizeof(float),
            sizeof(values)
        );
        point corners[3];
        for (int j = 0; j < 9; ++j)
        {
            if (!isUsable(scalar(values[j])))
            {
                throw std::runtime_error
                (
                    "triangle " + std::to_string(i + 1)
                  + " has a coordinate that" + noNumber
                );
            }
            corners[j/3][j % 3] = values[j];
        }
        appendTriangle(soup, corners, i + 1);
    }
    return soup;
}


namespace
{

//- The words of an STL file of text, one after the other
class stlText
{
    textLines lines_;

    //- Corners of the present triangle
    point corners_[3];
    label nCorners_ = 0;

    //- Word that must come next, empty between triangles
    std::string expected_;

    //- Fail unless the word is in place; another is in place next
    void take(const std::string& word, const std::string& next)
    {
        if (word != expected_)
        {
            lines_.fail
            (
                "here is '" + word + "', but "
              + (
                    expected_.empty() ? "a facet begins with 'facet'"
                  : "'" + expected_ + "' should be"
                )
            );
        }
        expected_ = next;
    }

    void readLine();

public:

    polygonSoup soup;

    explicit stlText(const std::string& text)
    :
        lines_(text)
    {
        while (lines_.next())
        {
            readLine();
        }
        if (!expected_.empty())
        {
            lines_.fail("the file ends within a triangle");
        }
    }
};


void stlText::readLine()
{
    const std::vector<std::string_view> words(wordsOf(lines_.line()));
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        std::string word(words[i].substr(0, 20));
        std::transform
        (
            word.begin(), word.end(), word.begin(),
            [](const unsigned char c) { return std::tolower(c); }
        );
        if (word == "solid" || word == "endsolid")
        {
            // A name follows, of any words
            expected_ = expected_.empty() ? word : expected_;
            take(word, "");
            return;
        }
        if (word == "facet")
        {
            expected_ = expected_.empty() ? word : expected_;
            take(word, "normal");
        }
        else if (word == "normal")
        {
            // Its numbers nobody needs, and some get them wrong
            take(word, "outer");
            i += 3;
        }
        else if (word == "outer")
        {
            take(word, "loop");
        }
        else if (word == "loop")
        {
            take(word, "vertex");
            nCorners_ = 0;
        }
        else if (word == "vertex")
        {
            take(word, nCorners_ == 2 ? "endloop" : "vertex");
            if (i + 3 >= words.size())
            {
                lines_.fail("a point has three coordinates");
            }
            for (direction d = 0; d < 3; ++d)
            {
                corners_[nCorners_][d] = lines_.number(words[++i]);
            }
            ++nCorners_;
        }
        else if (word == "endloop")
        {
            take(word, "endfacet");
        }
        else
        {
            take(word, "");
            appendTriangle(soup, corners_, lines_.number());
        }
    }
}

} // End anonymous namespace

} // End namespace surfaceFormats
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::surfaceFormats::polygonSoup Foam::fsi::surfaceFormats::readStl
(
    const std::string& text
)
{
    // A binary file's title may begin with any word
    const std::size_t start = text.find_first_not_of("\xef\xbb\xbf \t\r\n");
    const bool solid =
        start != std::string::npos
     && text.size() - start >= 5
     && std::equal
        (
            text.begin() + start, text.begin() + start + 5, "solid",
            [](const unsigned char a, const char b)
            {
                return std::tolower(a) == b;
            }
        );
    if (!solid || fitsBinary(text) || text.find('\0') != std::string::npos)
    {
        return readBinary(text);
    }
    return stlText(text).soup;
}


// ************************************************************************* //
