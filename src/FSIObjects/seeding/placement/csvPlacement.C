// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvPlacement.H"
#include "caseFile.H"
#include "IFstream.H"
#include "stringOps.H"
#include "addToRunTimeSelectionTable.H"

#include <sstream>

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(csvPlacement, 0);
    addToRunTimeSelectionTable(placement, csvPlacement, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Values of a line, without the space around them
static wordList splitLine(const string& line)
{
    DynamicList<word> values;
    for (const auto& part : stringOps::split(line, ','))
    {
        values.append(word(stringOps::trim(part.str()), false));
    }
    return wordList(std::move(values));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::csvPlacement::refuse
(
    const label line,
    const string& reason
) const
{
    FatalIOErrorInFunction(dict())
        << "Entry 'file' of placement " << name() << ": " << file_.c_str()
        << ", "
        << (line ? "line " + Foam::name(line) + ": " : string()).c_str()
        << reason.c_str()
        << exit(FatalIOError);
}


void Foam::fsi::csvPlacement::checkColumns
(
    const wordList& columns,
    const label line
) const
{
    const wordList known
    ({
        "x", "y", "z", "rotation", "shape",
        "velocityX", "velocityY", "velocityZ", "angularVelocityZ"
    });
    for (const word& column : columns)
    {
        if (!known.found(column))
        {
            OStringStream os;
            os  << "unknown column " << column.c_str()
                << ", valid columns are " << flatOutput(known);
            refuse(line, os.str());
        }
    }
    if (!columns.found("x") || !columns.found("y"))
    {
        refuse(line, "there must be columns x and y");
    }
}


Foam::scalar Foam::fsi::csvPlacement::number
(
    const string& text,
    const label line
) const
{
    // OpenFOAM's readScalar ends in a floating point exception for nan
    std::istringstream is(text);
    scalar value = 0;
    if (!(is >> value && is.eof()))
    {
        refuse(line, "not a number: " + text);
    }
    return value;
}


Foam::fsi::placedObject Foam::fsi::csvPlacement::readObject
(
    const packing& space,
    const wordList& columns,
    const wordList& values,
    const label line
)
{
    if (values.size() != columns.size())
    {
        refuse
        (
            line,
            Foam::name(values.size()) + " values for "
          + Foam::name(columns.size()) + " columns"
        );
    }

    const auto value = [&](const word& column, const scalar otherwise)
    {
        const label i = columns.find(column);
        return i < 0 ? otherwise : number(values[i], line);
    };
    const label shapeColumn = columns.find("shape");

    return newObject
    (
        shapeColumn < 0
      ? readShape(dict(), space)
      : findShape(values[shapeColumn], space),
        point(value("x", 0), value("y", 0), value("z", 0)),
        rotation(value("rotation", 0)),
        vector
        (
            value("velocityX", velocity().x()),
            value("velocityY", velocity().y()),
            value("velocityZ", velocity().z())
        ),
        vector(0, 0, value("angularVelocityZ", angularVelocity().z()))
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::csvPlacement::csvPlacement
(
    const word& name,
    const dictionary& dict,
    const packing&
)
:
    placement(name, dict, {"file"}, 0, 0),
    file_(readCaseFile(dict, "file"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::csvPlacement::place(packing& space)
{
    IFstream is(file_);
    if (!is.good())
    {
        refuse(0, "cannot be read");
    }

    wordList columns;
    DynamicList<placedObject> objects;
    string text;
    for (label line = 1; is.getLine(text).good(); ++line)
    {
        text = stringOps::trim(text);
        if (text.empty() || text[0] == '#')
        {
            continue;
        }
        const wordList values(splitLine(text));
        if (columns.empty())
        {
            columns = values;
            checkColumns(columns, line);
        }
        else
        {
            objects.append(readObject(space, columns, values, line));
        }
    }
    if (objects.empty())
    {
        refuse(0, "there are no objects");
    }
    insertAll(space, objects, "file");
}


// ************************************************************************* //
