// SPDX-License-Identifier: GPL-3.0-or-later

#include "polygon.H"
#include "addToRunTimeSelectionTable.H"
#include "caseFile.H"
#include "dictionaryCheck.H"
#include "DynamicList.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "polygonPredicates.H"
#include "unitConversion.H"

#include <cstdlib>
#include <fstream>
#include <sstream>

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

//- Is any of the comma-separated fields a number? A heading has none
static bool hasNumber(const std::string& line)
{
    std::istringstream fields(line);
    std::string field;
    while (std::getline(fields, field, ','))
    {
        char* end = nullptr;
        std::strtod(field.c_str(), &end);
        if (end != field.c_str())
        {
            return true;
        }
    }
    return false;
}


//- Take x and y of a line, < 1e15; columns after them are allowed
static bool readPoint(const std::string& line, point& p)
{
    std::istringstream values(line);
    char comma = 0;
    char after = ',';
    p.z() = 0;
    return
        values >> p.x() >> comma >> p.y()
     && comma == ','
     && mag(p.x()) < GREAT
     && mag(p.y()) < GREAT
     && (!(values >> after) || after == ',');
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
    const dictionary& dict,
    const fileName& file
)
{
    IFstream is(file);
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
    return pointField(is);
}


Foam::pointField Foam::fsi::polygon::readCsv
(
    const dictionary& dict,
    const fileName& file
)
{
    std::ifstream is(file);
    DynamicList<point> points;

    std::string line;
    for (label lineNumber = 1; std::getline(is, line); ++lineNumber)
    {
        // Some programs begin a file with the mark of its byte order
        if (lineNumber == 1 && line.compare(0, 3, "\xef\xbb\xbf") == 0)
        {
            line.erase(0, 3);
        }
        line = line.substr(0, line.find("#"));
        point p;
        if (readPoint(line, p))
        {
            points.append(p);
        }
        else if (points.size() || hasNumber(line))
        {
            if (line.find_first_not_of(" \t\r") >= line.size())
            {
                continue;
            }
            FatalIOErrorInFunction(dict)
                << "Entry 'file' in dictionary " << dict.name()
                << ": line " << lineNumber << " of " << file
                << " is not a pair x, y with a comma, below 1e15"
                << exit(FatalIOError);
        }
    }
    return pointField(std::move(points));
}


Foam::pointField Foam::fsi::polygon::read(const dictionary& dict)
{
    const fileName file(readCaseFile(dict, "file"));
    if (!isFile(file, false))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file' in dictionary " << dict.name()
            << ": cannot read the file " << file << exit(FatalIOError);
    }

    pointField points
    (
        file.ext() == "csv" ? readCsv(dict, file) : readList(dict, file)
    );
    withoutRepeats(points);
    if (points.size() < 3 || !polygonPredicates::isSimple(points))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file' in dictionary " << dict.name()
            << ": the polygon of " << points.size() << " points in " << file
            << (points.size() < 3 ? " has no inside" : " crosses itself")
            << exit(FatalIOError);
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


// ************************************************************************* //
