// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvPlacement.H"
#include "caseFile.H"
#include "IFstream.H"
#include "rotations.H"
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
    wordList known
    ({
        "x", "y", "z", "rotation", "shape",
        "velocityX", "velocityY", "velocityZ", "angularVelocityZ"
    });
    if (nDims() == 3)
    {
        known.append
        (
            wordList
            ({
                "axisX", "axisY", "axisZ", "angle",
                "quaternionW", "quaternionX", "quaternionY", "quaternionZ",
                "angularVelocityX", "angularVelocityY"
            })
        );
    }
    forAll(columns, i)
    {
        if (!known.found(columns[i]))
        {
            OStringStream os;
            os  << "unknown column " << columns[i].c_str()
                << ", valid columns are " << flatOutput(known);
            refuse(line, os.str());
        }
        if (columns.find(columns[i]) < i)
        {
            refuse(line, "column " + columns[i] + " is there twice");
        }
    }

    checkRotations(columns, line);
    if
    (
        !columns.found("x") || !columns.found("y")
     || (nDims() == 3 && !columns.found("z"))
    )
    {
        refuse
        (
            line,
            string("there must be columns x and y")
          + (nDims() == 3 ? " and z" : "")
        );
    }
}


void Foam::fsi::csvPlacement::checkRotations
(
    const wordList& columns,
    const label line
) const
{
    const wordList sets[3] =
    {
        {"rotation"},
        {"axisX", "axisY", "axisZ", "angle"},
        {"quaternionW", "quaternionX", "quaternionY", "quaternionZ"}
    };
    label nRotations = 0;
    for (const wordList& set : sets)
    {
        label nFound = 0;
        for (const word& column : set)
        {
            nFound += columns.found(column);
        }
        if (nFound != 0 && nFound != set.size())
        {
            OStringStream os;
            os  << "there must be all or none of the columns "
                << flatOutput(set);
            refuse(line, os.str());
        }
        nRotations += nFound != 0;
    }
    if (nRotations > 1)
    {
        refuse(line, "there is more than one kind of rotation");
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
        const string n(Foam::name(columns.size()));
        refuse(line, Foam::name(values.size()) + " values, not " + n);
    }

    const auto value = [&](const word& column, const scalar otherwise)
    {
        const label i = columns.find(column);
        return i < 0 ? otherwise : number(values[i], line);
    };
    const auto triple = [&](const word& name, const vector& otherwise)
    {
        return vector
        (
            value(name + 'X', otherwise.x()),
            value(name + 'Y', otherwise.y()),
            value(name + 'Z', otherwise.z())
        );
    };
    const label shapeColumn = columns.find("shape");
    const auto rotation = [&]()
    {
        if (columns.found("axisX"))
        {
            const vector axis(triple("axis", Zero));
            if (!(mag(axis) > VSMALL))
            {
                refuse(line, "the axis must not be zero");
            }
            return rotationAbout(axis, value("angle", 0));
        }
        if (columns.found("quaternionW"))
        {
            const scalar w = value("quaternionW", 0);
            const vector v(triple("quaternion", Zero));
            if (!(max(mag(w), mag(v)) > VSMALL))
            {
                refuse(line, "the quaternion must not be zero");
            }
            return rotationOf(w, v);
        }
        return rotationAboutZ(value("rotation", 0));
    };

    return newObject
    (
        shapeColumn < 0
      ? readShape(dict(), space)
      : findShape(values[shapeColumn], space),
        checkedCentre
        (
            point(value("x", 0), value("y", 0), value("z", 0)), space
        ),
        rotation(),
        triple("velocity", velocity()),
        triple("angularVelocity", angularVelocity())
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::csvPlacement::csvPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    placement(name, dict, space, {"file"}, 0, 0),
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
