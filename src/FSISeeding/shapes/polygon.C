// SPDX-License-Identifier: GPL-3.0-or-later

#include "polygon.H"
#include "addToRunTimeSelectionTable.H"
#include "caseFile.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "IStringStream.H"
#include "outlineTools.H"
#include "polygonPredicates.H"
#include "unitConversion.H"
#include "valueTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(polygon, 0);
    addToRunTimeSelectionTable(shape, polygon, planar);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Is the text a list of OpenFOAM, perhaps with a header, or its length? Other
//  texts are rows of values
static bool isList(const std::string& text)
{
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string::npos)
    {
        return false;
    }
    const std::size_t next =
        text.find_first_not_of("0123456789 \t\r\n", start);
    return
        (next != std::string::npos && text[next] == '(')
     || text.compare(start, 8, "FoamFile") == 0
     || text[start] == '/';
}


//- Move points to z = 0 and drop those that are equal to the one before
static void withoutRepeats(pointField& points)
{
    label n = 0;
    for (point& p : points)
    {
        p.z() = 0;
        if (n == 0 || p != points[n - 1])
        {
            points[n++] = p;
        }
    }
    if (n > 1 && points[0] == points[n - 1])
    {
        --n;
    }
    points.setSize(n);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::fsi::polygon::readList
(
    const caseFile& file,
    const std::string& text
)
{
    pointField points;
    const caughtError error = fsi::errorOf
    ([&]()
    {
        IStringStream is(text);
        token first(is);

        // A header is allowed
        if (first.isWord() && first.wordToken() == "FoamFile")
        {
            dictionary header(is);
        }
        else
        {
            is.putBack(first);
        }
        is >> points;
        if (token(is).good())
        {
            FatalIOErrorInFunction(is)
                << "there is something behind the list" << exit(FatalIOError);
        }
    });
    const string line
    (
        error.line > 0 ? ", line " + Foam::name(error.line) : string()
    );
    if (error.message.size())
    {
        file.fail(line + ": the list of points cannot be read: "
            + error.message);
    }
    forAll(points, i)
    {
        if (!isUsable(points[i]))
        {
            file.fail
            (
                ": point " + std::to_string(i)
              + " of the list has a coordinate that is no number below 1e15"
            );
        }
    }
    return points;
}


Foam::pointField Foam::fsi::polygon::readRows(const caseFile& file)
{
    const valueTable table(file, {"x", "y"});
    pointField points(table.size());
    forAll(points, i)
    {
        points[i] = point(table.number(i, "x"), table.number(i, "y"), 0);
    }
    return points;
}


Foam::pointField Foam::fsi::polygon::read(const dictionary& dict)
{
    const caseFile file(dict, "file");
    const std::string text(file.text());
    pointField points(isList(text) ? readList(file, text) : readRows(file));
    withoutRepeats(points);
    if (points.size() < 3 || !polygonPredicates::isSimple(points))
    {
        file.fail
        (
            ": the polygon of its " + std::to_string(points.size()) + " points"
          + (points.size() < 3 ? " has no inside" : " crosses itself")
        );
    }
    return points*readPositive(dict, "scale", 1);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::polygon::polygon(const dictionary& dict)
:
    cornerAngle_(degToRad(readPositive(dict, "cornerAngle", 20))),
    points_(read(dict))
{
    checkKeys(dict, {"type", "file", "scale", "cornerAngle"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::fsi::polygon::curve() const
{
    return points_;
}


Foam::scalar Foam::fsi::polygon::cornerAngle() const
{
    return cornerAngle_;
}


Foam::point Foam::fsi::polygon::centroid() const
{
    return outlineTools::centroid(points_);
}


// ************************************************************************* //
