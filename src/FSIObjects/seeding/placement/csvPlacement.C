// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvPlacement.H"
#include "caseFile.H"
#include "IFstream.H"
#include "openfoamVersion.H"
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
    std::istringstream parts(line);
    std::string part;
    while (std::getline(parts, part, ','))
    {
        if (part.size())
        {
            values.append(word(stringOps::trim(part), false));
        }
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
        if (!isIn(known, columns[i]))
        {
            OStringStream os;
            os  << "unknown column " << columns[i].c_str()
                << ", valid columns are " << flatOutput(known);
            refuse(line, os.str());
        }
        if (indexOf(columns, columns[i]) < i)
        {
            refuse(line, "column " + columns[i] + " is there twice");
        }
    }

    checkRotations(columns, line);
    if
    (
        !isIn(columns, "x") || !isIn(columns, "y")
     || (nDims() == 3 && !isIn(columns, "z"))
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
            nFound += isIn(columns, column);
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


Foam::fsi::placedObject Foam::fsi::csvPlacement::readObject
(
    const packing& space,
    const csvRow& values
)
{
    const scalar vz = values.value("velocityZ", velocity().z());
    if (nDims() == 2 && vz != 0)
    {
        values.refuse("velocityZ must be 0 in two dimensions");
    }
    return newObject
    (
        values.has("shape")
      ? findShape(values.text("shape"), space)
      : readShape(dict(), space),
        checkedCentre
        (
            point
            (
                values.value("x", 0),
                values.value("y", 0),
                values.value("z", 0)
            ),
            space
        ),
        values.rotation(),
        values.triple("velocity", velocity()),
        values.triple("angularVelocity", angularVelocity())
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
        if (columns.empty())
        {
            columns = splitLine(text);
            checkColumns(columns, line);
        }
        else
        {
            objects.append
            (
                readObject
                (
                    space,
                    csvRow
                    (
                        columns,
                        splitLine(text),
                        [=](const string& reason) { refuse(line, reason); }
                    )
                )
            );
        }
    }
    if (objects.empty())
    {
        refuse(0, "there are no objects");
    }
    insertAll(space, objects, "file", file_);
}


// ************************************************************************* //
