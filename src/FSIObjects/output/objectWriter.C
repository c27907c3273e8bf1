// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectWriter.H"
#include "dictionaryCheck.H"
#include "functionObject.H"
#include "objectPolyData.H"
#include "Switch.H"

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
    nSteps_(0)
{
    checkKeys
    (
        dict,
        {"surfaces", "springs", "binary", "globalEvery", "objectsEvery"}
    );
    if (!Pstream::master())
    {
        return;
    }

    const fileName folder
    (
        time.globalPath()/functionObject::outputPrefix/population::folder
       /time.timeName(time.startTime().value())
    );
    const bool binary = dict.lookupOrDefault<Switch>("binary", true);

    objectTable_.reset
    (
        new csvTable(folder/"objects.csv", objectRecord::columns(nDims_))
    );
    globalTable_.reset
    (
        new csvTable(folder/"global.csv", stepRecord::columns())
    );
    if (dict.lookupOrDefault<Switch>("surfaces", true))
    {
        surfaceSeries_.reset(new polyDataSeries(folder, "surfaces", binary));
    }
    if (dict.lookupOrDefault<Switch>("springs", true))
    {
        springSeries_.reset(new polyDataSeries(folder, "springs", binary));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
            record.write(objectTable_(), time, nDims_);
        }
    }
}


void Foam::fsi::objectWriter::writeShapes
(
    const scalar time,
    const population& objects
)
{
    if (surfaceSeries_.valid())
    {
        surfaceSeries_().write(surfacePolyData(objects), time);
    }
    if (springSeries_.valid())
    {
        springSeries_().write(springPolyData(objects), time);
    }
}


// ************************************************************************* //
