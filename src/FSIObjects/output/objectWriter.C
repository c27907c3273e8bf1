// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectWriter.H"
#include "nodesInside.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamTypes.H"
#include "objectPolyData.H"
#include "surfacePredicates.H"
#include "timeFolders.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static const char* const crossingAdvice =
    "take a smaller deltaT or a finer mesh, or stiffer objects";


//- Folder of the tables of a run
static fileName folderOf(const Time& time)
{
    return
        time.globalPath()/outputFolder()/bodyGroups::folder
       /time.timeName(time.startTime().value());
}


//- Ids of the free objects whose surface cuts itself
static labelList crossedObjects(const population& objects)
{
    DynamicList<label> ids;
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        if
        (
            objects.movesFreely(objecti)
         && surfacePredicates::cutsItself(objects.surfaces(), objecti)
        )
        {
            ids.append(objects.objectId(objecti));
        }
    }
    return labelList(ids);
}


//- Print how many nodes are inside membranes or, of membranes, inside other
//  objects. Is there one?
static bool reportInside(const surfaceSet& surfaces, const vector& period)
{
    label nNodes = 0;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (!surfaces.hasWalls(objecti))
        {
            const label start = surfaces.pointStart()[objecti];
            nNodes += surfaces.pointStart()[objecti + 1] - start;
        }
    }
    if (nNodes == 0)
    {
        return false;
    }
    const insideCounts inside(nodesInside(surfaces, period));
    Info<< "Nodes of membranes inside other objects: " << inside.ofMembranes
        << " of " << nNodes;
    if (inside.ofOthers > 0)
    {
        Info<< ", nodes of other objects inside membranes: "
            << inside.ofOthers;
    }
    Info<< endl;
    return inside.ofMembranes + inside.ofOthers > 0;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectWriter::objectWriter
(
    const Time& time,
    const dictionary& dict,
    const direction nDims
)
:
    nDims_(nDims),
    globalEvery_(readAtLeast(dict, "globalEvery", 1, 1)),
    objectsEvery_(readAtLeast(dict, "objectsEvery", 0, 0)),
    nSteps_(0),
    stopsAtCrossing_
    (
        readChoice(dict, "crossing", "stop", {"stop", "warn"}) == "stop"
    ),
    stresses_(readEntryOr<Switch>(dict, "rheology", false))
{
    checkKeys
    (
        dict,
        {
            "surfaces", "springs", "globalEvery", "objectsEvery", "log",
            "crossing", "rheology"
        }
    );
    if (!Pstream::master())
    {
        return;
    }

    const fileName folder(folderOf(time));

    objectTable_.reset
    (
        new csvTable
        (
            folder/"objects.csv", objectRecord::columns(nDims_, stresses_)
        )
    );
    globalTable_.reset
    (
        new csvTable(folder/"global.csv", stepRecord::columns())
    );
    if (dict.lookupOrDefault<Switch>("surfaces", true))
    {
        surfaceSeries_.reset(new polyDataSeries(folder, "surfaces"));
    }
    if (dict.lookupOrDefault<Switch>("springs", true))
    {
        springSeries_.reset(new polyDataSeries(folder, "springs"));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::csvTable> Foam::fsi::objectWriter::newTable
(
    const Time& time,
    const word& name,
    const wordList& columns
)
{
    return autoPtr<csvTable>
    (
        Pstream::master()
      ? new csvTable(folderOf(time)/name + ".csv", columns)
      : nullptr
    );
}


void Foam::fsi::objectWriter::writeStep(const stepRecord& record)
{
    if (nSteps_++ % globalEvery_ == 0 && globalTable_.valid())
    {
        record.write(globalTable_());
    }
}


void Foam::fsi::objectWriter::writeRows
(
    const scalar time,
    const List<objectRecord>& records
)
{
    if (objectTable_.valid())
    {
        for (const objectRecord& record : records)
        {
            record.write(objectTable_(), time, nDims_, stresses_);
        }
    }
}


bool Foam::fsi::objectWriter::writeShapes
(
    const scalar time,
    const population& objects,
    const vector& period,
    const vectorField& tractions
)
{
    bool overlaps = false;
    if (globalTable_.valid())
    {
        overlaps = reportInside(objects.surfaces(), period);
        crossed_ = crossedObjects(objects);
        crossedAt_ = time;
        if (crossed_.size())
        {
            WarningInFunction
                << "At time " << time << " the surfaces of these objects cut"
                << " themselves: " << flatOutput(crossed_) << nl
                << "    The run is wrong from here: " << crossingAdvice << nl
                << endl;
        }
    }
    if (surfaceSeries_.valid())
    {
        polyData surfaces(surfacePolyData(objects));
        surfaces.pointVectors("traction") = tractions;
        surfaceSeries_().write(surfaces, time);
    }
    if (springSeries_.valid())
    {
        springSeries_().write(springPolyData(objects), time);
    }
    return overlaps;
}


void Foam::fsi::objectWriter::checkCrossing() const
{
    if (crossed_.size() && stopsAtCrossing_)
    {
        FatalErrorInFunction
            << "At time " << crossedAt_ << ", which is written, the surfaces of"
            << " these objects cut themselves: " << flatOutput(crossed_) << nl
            << "The run is wrong from there: " << crossingAdvice << nl
            << "Entry 'crossing warn' in 'output' of fsiProperties lets a run"
            << " go on all the same" << exit(FatalError);
    }
}


// ************************************************************************* //
