// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFormats.H"
#include "textLines.H"

#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace surfaceFormats
{

typedef std::vector<std::string_view> wordsOfLine;


//- The point whose coordinates are three words of a line
static point pointOf
(
    const textLines& lines,
    const wordsOfLine& words,
    const std::size_t first
)
{
    if (words.size() < first + 3)
    {
        lines.fail("a point has three coordinates");
    }
    return point
    (
        lines.number(words[first]),
        lines.number(words[first + 1]),
        lines.number(words[first + 2])
    );
}


//- Corners of an OBJ's face, CORNER[/TEXTURE[/NORMAL]] each: from 1, or
//  backwards from the last point so far
static std::vector<label> cornersOf
(
    const textLines& lines,
    const wordsOfLine& words,
    const label nPoints
)
{
    std::vector<label> corners;
    for (std::size_t i = 1; i < words.size(); ++i)
    {
        const label l =
            lines.wholeNumber(words[i].substr(0, words[i].find('/')));
        if (l == 0 || l < -nPoints)
        {
            lines.fail
            (
                "corner " + std::to_string(l) + ", but points count from 1"
                " and, backwards, from -1 to "
              + std::to_string(-nPoints)
            );
        }
        corners.push_back(l > 0 ? l - 1 : nPoints + l);
    }
    return corners;
}


static polygonSoup readObj(const std::string& text)
{
    polygonSoup soup;
    textLines lines(text);
    std::string joined;
    while (lines.nextFilled('#'))
    {
        // A line that ends in \ goes on in the next
        joined = lines.line();
        while (joined.back() == '\\' && lines.next())
        {
            joined.back() = ' ';
            joined += trimmed(lines.line());
        }
        const wordsOfLine words(wordsOf(joined));
        if (words[0] == "v")
        {
            soup.points.push_back(pointOf(lines, words, 1));
        }
        else if (words[0] == "f")
        {
            soup.append
            (
                cornersOf(lines, words, soup.points.size()), lines.number()
            );
        }
    }
    return soup;
}


//- The next line of an OFF file, of which the counts promise one
static wordsOfLine promisedLine(textLines& lines, const std::string& what)
{
    if (!lines.nextFilled('#'))
    {
        lines.fail("the file ends, but its head promises more " + what);
    }
    return wordsOf(lines.line());
}


static polygonSoup readOff(const std::string& text)
{
    polygonSoup soup;
    textLines lines(text);
    wordsOfLine words(promisedLine(lines, "lines"));
    const std::string kind(words[0]);
    if
    (
        kind.size() < 3 || kind.compare(kind.size() - 3, 3, "OFF") != 0
     || kind.find_first_of("4n") != std::string::npos
     || (words.size() > 1 && words[1] == "BINARY")
    )
    {
        lines.fail("an OFF file begins with the word OFF, and is text");
    }
    words.erase(words.begin());
    if (words.empty())
    {
        words = promisedLine(lines, "lines");
    }
    if (words.size() < 2)
    {
        lines.fail("the numbers of points and faces are missing");
    }
    const label nPoints = lines.wholeNumber(words[0]);
    const label nFaces = lines.wholeNumber(words[1]);

    for (label i = 0; i < nPoints; ++i)
    {
        words = promisedLine(lines, "points");
        soup.points.push_back(pointOf(lines, words, 0));
    }
    for (label i = 0; i < nFaces; ++i)
    {
        words = promisedLine(lines, "faces");
        const label n = lines.wholeNumber(words[0]);
        if (n < 0 || n >= label(words.size()))
        {
            lines.fail("a face of " + std::string(words[0]) + " corners has "
                + std::to_string(words.size() - 1));
        }
        std::vector<label> corners;
        for (label j = 1; j <= n; ++j)
        {
            corners.push_back(lines.wholeNumber(words[j]));
        }
        soup.append(corners, lines.number());
    }
    if (lines.nextFilled('#'))
    {
        lines.fail("there is more than the counts in the head say");
    }
    return soup;
}


//- std::runtime_error if a corner is no point, or a polygon no polygon
static void check(const polygonSoup& soup)
{
    const label nPoints = soup.points.size();
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    {
        const std::string place
        (
            std::string(soup.unit) + ' ' + std::to_string(soup.places[i])
        );
        if (soup.polygons[i].size() < 3)
        {
            throw std::runtime_error
            (
                place + ": a face of less than three corners"
            );
        }
        for (const label l : soup.polygons[i])
        {
            if (l < 0 || l >= nPoints)
            {
                throw std::runtime_error
                (
                    place + ": a corner of the face is not one of the "
                  + std::to_string(nPoints) + " points"
                );
            }
        }
    }
}

} // End namespace surfaceFormats
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fsi::surfaceFormats::endings()
{
    return {"stl", "stlb", "obj", "off"};
}


Foam::fsi::surfaceFormats::polygonSoup Foam::fsi::surfaceFormats::read
(
    const std::string& ending,
    const std::string& text
)
{
    const polygonSoup soup
    (
        ending == "obj" ? readObj(text)
      : ending == "off" ? readOff(text)
      : readStl(text)
    );
    check(soup);
    return soup;
}


// ************************************************************************* //
