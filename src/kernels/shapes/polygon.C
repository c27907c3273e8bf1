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

#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(polygon, 0);
    addToRunTimeSelectionTable(shape, polygon, dictionary);
}
}


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
        std::istringstream values(line.substr(0, line.find("#")));
        scalar x, y;
        char comma;
        if (values >> x >> comma >> y && comma == ',')
        {
            points.append(point(x, y, 0));
        }
        else if (points.size() && line.find_first_not_of(" \t\r") < line.size())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'file' in dictionary " << dict.name()
                << ": line " << lineNumber << " of " << file
                << " is not a pair x, y" << exit(FatalIOError);
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
        file.hasExt("csv") ? readCsv(dict, file) : readList(dict, file)
    );
    if (points.size() > 1 && points.first() == points.last())
    {
        points.setSize(points.size() - 1);
    }
    for (point& p : points)
    {
        p.z() = 0;
    }
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
