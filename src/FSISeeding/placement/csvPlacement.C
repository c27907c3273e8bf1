// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvPlacement.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "OStringStream.H"
#include "rotations.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(csvPlacement, 0);
    addToRunTimeSelectionTable(placement, csvPlacement, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::csvPlacement::checkColumns
(
    const valueTable& table
) const
{
    const wordList& columns = table.columns();
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
                "eulerX", "eulerY", "eulerZ",
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
            table.refuse(os.str());
        }
        if (indexOf(columns, columns[i]) < i)
        {
            table.refuse("column " + columns[i] + " is there twice");
        }
    }

    checkRotations(table);
    if
    (
        !isIn(columns, "x") || !isIn(columns, "y")
     || (nDims() == 3 && !isIn(columns, "z"))
    )
    {
        table.refuse
        (
            std::string("there must be columns x and y")
          + (nDims() == 3 ? " and z" : "")
        );
    }
}


void Foam::fsi::csvPlacement::checkRotations
(
    const valueTable& table
)
{
    const wordList sets[4] =
    {
        {"rotation"},
        {"axisX", "axisY", "axisZ", "angle"},
        {"quaternionW", "quaternionX", "quaternionY", "quaternionZ"},
        {"eulerX", "eulerY", "eulerZ"}
    };
    label nRotations = 0;
    for (const wordList& set : sets)
    {
        label nFound = 0;
        for (const word& column : set)
        {
            nFound += table.has(column);
        }
        if (nFound != 0 && nFound != set.size())
        {
            OStringStream os;
            os  << "there must be all or none of the columns "
                << flatOutput(set);
            table.refuse(os.str());
        }
        nRotations += nFound != 0;
    }
    if (nRotations > 1)
    {
        table.refuse("there is more than one kind of rotation");
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
        values.refuse("velocityZ", "must be 0 in two dimensions");
    }
    const word shape
    (
        values.has("shape")
      ? values.text("shape") : getEntry<word>(dict(), "shape")
    );
    if (values.has("shape") && !isIn(space.shapeNames(), shape))
    {
        OStringStream os;
        os  << "unknown shape '" << shape.c_str() << "', valid shapes are "
            << flatOutput(space.shapeNames());
        values.refuse("shape", os.str());
    }
    const point centre
    (
        scale_*values.value("x", 0),
        scale_*values.value("y", 0),
        scale_*values.value("z", 0)
    );
    const caughtError error = errorOf([&]() { checkedCentre(centre, space); });
    if (error.message.size())
    {
        values.refuse("z", error.message);
    }
    return newObject
    (
        findShape(shape, space),
        centre,
        values.rotation(),
        values.triple("velocity", velocity()),
        values.triple("angularVelocity", angularVelocity())
    );
}


Foam::wordList Foam::fsi::csvPlacement::givenColumns() const
{
    return
        hemoCell_
      ? wordList({"x", "y", "z", "eulerX", "eulerY", "eulerZ"})
      : wordList();
}


void Foam::fsi::csvPlacement::insertFitting
(
    packing& space,
    const UList<placedObject>& objects
) const
{
    label nLeft = 0;
    for (const placedObject& object : objects)
    {
        const bool fits =
            space.inDomain(object, space.placed(object), wallGap())
         && space.findConflict(object, minimumGap()) < 0;
        nLeft += !fits;
        if (fits)
        {
            space.insert(object);
        }
    }
    Info<< "Left out " << nLeft << " of the " << objects.size()
        << " objects of placement " << name()
        << ": they are not in the domain or too near to others" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::csvPlacement::csvPlacement
(
    const word& name,
    const dictionary& dict,
    const packing& space
)
:
    placement(name, dict, space, {"file", "scale", "misfits"}, 0, 0),
    file_(dict, "file"),
    hemoCell_(nDims() == 3 && file_.name().ext() == "pos"),
    scale_(readPositive(dict, "scale", hemoCell_ ? 1e-6 : 1)),
    leavesOut_
    (
        readChoice(dict, "misfits", "refuse", {"refuse", "leaveOut"})
     == "leaveOut"
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::csvPlacement::place(packing& space)
{
    const valueTable table(file_, givenColumns());
    checkColumns(table);
    if (table.size() == 0)
    {
        file_.fail(": there are no objects");
    }
    DynamicList<placedObject> objects(table.size());
    for (label i = 0; i < table.size(); ++i)
    {
        objects.append(readObject(space, csvRow(table, i)));
    }
    leavesOut_
  ? insertFitting(space, objects)
  : insertAll(space, objects, "file", file_.name());
}


// ************************************************************************* //
