// SPDX-License-Identifier: GPL-3.0-or-later

#include "seedRecord.H"
#include "dictionaryCheck.H"
#include "IOdictionary.H"
#include "OFstream.H"
#include "openfoamTime.H"
#include "openfoamVersion.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace seedRecord
{

static const char* const advice = "Run seedObjects on this mesh";


static IOobject input(const Time& time, const IOobject::readOption option)
{
    return IOobject
    (
        "fsiSeeding", time.constant(), time, option, IOobject::NO_WRITE, false
    );
}


//- Fatal if a free object is not wholly in the box
static void checkPlaces
(
    const dictionary& record,
    const population& objects,
    const domainSides& sides,
    const boundBox& before
)
{
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        const boundBox box(objects.surfaces().bounds(objecti));
        bool outside = false;
        for (label sidei = 0; sidei < 2*label(objects.nDims()); ++sidei)
        {
            const direction d = sidei/2;
            outside = outside
             || (
                    sides[sidei] != domainSides::CYCLIC
                 && (
                        sidei % 2
                      ? box.max()[d] > sides.bounds().max()[d]
                      : box.min()[d] < sides.bounds().min()[d]
                    )
                );
        }
        if
        (
            outside
         && objects.groups()[objects.objectGroup(objecti)].movesFreely()
        )
        {
            FatalIOErrorInFunction(record)
                << "Entries 'min' and 'max' in dictionary " << record.name()
                << ": objects were seeded in the box " << before
                << ", but the mesh's is " << sides.bounds() << nl
                << "Object " << objects.objectId(objecti) << ", from "
                << box.min() << " to " << box.max() << ", is not in it. "
                << advice << exit(FatalIOError);
        }
    }
    WarningInFunction
        << "Objects were seeded in the box " << before
        << ", but the mesh's is " << sides.bounds() << nl
        << "    All of them are in it; if this is not meant: " << advice << nl
        << endl;
}


//- Fatal if a shape has too few of the mesh's cells across
static void checkCells
(
    const dictionary& record,
    const scalar before,
    const scalar spacing
)
{
    const dictionary& shapes = record.subDict("shapes");
    for (const entry& e : shapes)
    {
        const scalar thickness = readPositive(e.dict(), "thickness");
        const scalar cells = readNonNegative(e.dict(), "minimumCells", 3);
        if (thickness < cells*spacing)
        {
            FatalIOErrorInFunction(record)
                << "Entry 'cellSize' in dictionary " << record.name()
                << ": objects were seeded for cells of " << before
                << " m, but the mesh's are " << spacing << " m: shape "
                << e.keyword() << ", " << thickness
                << " m thick at its thinnest, has " << thickness/spacing
                << " of them, fewer than " << cells << nl << advice
                << exit(FatalIOError);
        }
    }
    WarningInFunction
        << "Objects were seeded for cells of " << before
        << " m, but the mesh's are " << spacing
        << " m: their nodes are as far apart as before, and have to suit both"
        << nl << "    If this is not meant: " << advice << nl << endl;
}

} // End namespace seedRecord
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::seedRecord::write
(
    const Time& time,
    const seedDomain& domain,
    const UList<thickness>& shapes
)
{
    IOdictionary record(input(time, IOobject::NO_READ));
    record.add("cellSize", domain.spacing);
    record.add("min", domain.bounds.min());
    record.add("max", domain.bounds.max());
    dictionary all;
    for (const thickness& t : shapes)
    {
        dictionary one;
        one.add("thickness", t.value);
        one.add("minimumCells", t.minimumCells);
        all.add(t.shape, one);
    }
    record.add("shapes", all);

    OFstream os(time.path()/time.constant()/"fsiSeeding");
    os.precision(15);
    record.writeHeader(os);
    record.dictionary::write(os, false);
}


void Foam::fsi::seedRecord::check
(
    const population& objects,
    const Time& time,
    const domainSides& sides,
    const scalar spacing
)
{
    const IOdictionary record(input(time, IOobject::READ_IF_PRESENT));
    if (record.empty())
    {
        return;
    }
    checkKeys(record, {"FoamFile", "cellSize", "min", "max", "shapes"});
    checkSubDicts(record, {"shapes"});
    const boundBox box(readFinite(record, "min"), readFinite(record, "max"));
    const scalar cell = readPositive(record, "cellSize");

    // Meshes are written with six digits
    const scalar moved = max
    (
        mag(box.min() - sides.bounds().min()),
        mag(box.max() - sides.bounds().max())
    );
    if (moved > 1e-4*box.mag())
    {
        checkPlaces(record, objects, sides, box);
    }
    if (mag(cell - spacing) > 1e-3*cell)
    {
        checkCells(record, cell, spacing);
    }
}


// ************************************************************************* //
