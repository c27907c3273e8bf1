// SPDX-License-Identifier: GPL-3.0-or-later

#include "restartFiles.H"
#include "errorOf.H"
#include "dictionaryCheck.H"
#include "openfoamFiles.H"
#include "openfoamMesh.H"
#include "OSspecific.H"
#include "stateChecks.H"
#include "stateFile.H"
#include "sumOverRanks.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A file that a restart reads, and what happens without it
struct restartFile
{
    const char* name;
    const char* without;
};

static const restartFile fieldFiles[] =
{
    {"phi", "the fluxes are interpolated from U"},
    {"faceHistory", "the velocities of faces start without their history"},
    {"filmChange", "films between objects start anew"},
    {"forcingCoefficient", "the load of the fluid on objects starts anew"},
    {"velocityRate", "the error of the first step is not known"},
    {"pressureRate", "the first pressure is found from another start"}
};

static const restartFile uniformFiles[] =
{
    {"fsiDrivingForce", "the driving force starts anew"},
    {"fsiFrame", "the frame is taken to be at rest, and sides are not"},
    {
        "fsiBoundaries",
        "feeds and the counts of objects that left start anew, and"
        " checkObjects finds objects lost"
    },
    {
        "fsiPressureLevel",
        "objects feel the level of the pressure (pRefValue) as a load"
    },
    {"fsiForcing", "the load of the fluid on objects starts anew"},
    {"fsiTimeError", "the error of a step is not known in the first ones"},
    {"fsiTimeStep", "the time step starts anew"}
};


//- Names of the fields of a type that are written
template<class Field>
static void appendWritten(const fvMesh& mesh, DynamicList<word>& names)
{
    for (const word& name : namesIn<Field>(mesh))
    {
        if
        (
            mesh.lookupObject<Field>(name).writeOpt() == IOobject::AUTO_WRITE
        )
        {
            names.append(name);
        }
    }
}


//- Warn if a listed file is not there, fatal if on some ranks or cut. The state
//  in `uniform` is that of the first rank
static void checkFile
(
    const dictionary& list,
    const Time& time,
    const fileName& folder,
    const restartFile& file
)
{
    const IOobject io
    (
        stateFile::input(time, nameOf(time), folder, file.name)
    );
    const fileName here(foundPath(io));
    const fileName path(folder.empty() ? here : ofFirstRank(here));
    const bool found = !path.empty();
    label nFound = 0;
    const List<label> all(gatherOverRanks(label(found)));
    for (const label n : all)
    {
        nFound += n;
    }
    if (nFound == 0)
    {
        IOWarningInFunction(list)
            << "File " << pathOf(io) << " is missing, though the time was"
            << " written with it: " << file.without << ", so that the run does"
            << " not go on as if it had not stopped" << nl << endl;
    }
    else if (nFound < all.size())
    {
        FatalIOErrorInFunction(list)
            << "File " << file.name << " of the time's folder is missing on "
            << all.size() - nFound << " ranks: run reconstructPar and"
            << " decomposePar, or remove it on all ranks"
            << exit(FatalIOError);
    }
    if (found && isFile(path, false) && !writtenFiles::hasEnd(path))
    {
        FatalIOErrorInFunction(list)
            << "File " << path << " is cut. Start from another time"
            << exit(FatalIOError);
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::restartFiles::takeTime(Time& time)
{
    const dictionary written(readState(time, "time"));
    const scalar value = readEntryOr<scalar>(written, "value", time.value());
    if (Time::timeName(value) == nameOf(time))
    {
        time.setTime(value, time.timeIndex());
    }
}


void Foam::fsi::restartFiles::write(const fvMesh& mesh)
{
    const Time& time = mesh.time();
    DynamicList<word> fields;
    appendWritten<volScalarField>(mesh, fields);
    appendWritten<volVectorField>(mesh, fields);
    appendWritten<surfaceScalarField>(mesh, fields);
    DynamicList<word> files;
    for (const restartFile& file : uniformFiles)
    {
        const IOobject io
        (
            stateFile::input(time, nameOf(time), "uniform", file.name)
        );
        if (stateFile::exists(io))
        {
            files.append(file.name);
        }
    }
    writeFile
    (
        time, nameOf(time), "uniform", "fsiRestart", IOstream::ASCII,
        [&](Ostream& os)
        {
            putEntry(os, "fields", fields);
            putEntry(os, "files", files);
        }
    );
}


void Foam::fsi::restartFiles::check
(
    const fvMesh& mesh,
    const wordList& volumes
)
{
    const Time& time = mesh.time();
    const dictionary list(readState(time, "fsiRestart"));
    if (list.empty())
    {
        return;
    }
    checkKeys(list, {"FoamFile", "fields", "files"});
    if
    (
        time.writeFormat() == IOstream::ASCII
     && IOstream::defaultPrecision() < 17
    )
    {
        WarningInFunction
            << "Fields are written with writePrecision "
            << IOstream::defaultPrecision() << ": the run goes on from rounded"
            << " ones. Take writeFormat binary, or writePrecision 17, for the"
            << " run without a stop" << nl << endl;
    }
    const wordList fields(readEntry<wordList>(list, "fields"));
    const wordList files(readEntry<wordList>(list, "files"));
    for (const restartFile& file : fieldFiles)
    {
        if (isIn(fields, file.name))
        {
            checkFile(list, time, "", file);
        }
    }
    for (const word& name : volumes)
    {
        if (isIn(fields, name))
        {
            checkFile
            (
                list, time, "",
                {name.c_str(), "the volumes that cells hold start anew"}
            );
        }
    }
    for (const restartFile& file : uniformFiles)
    {
        if (isIn(files, file.name))
        {
            checkFile(list, time, "uniform", file);
        }
    }
}


// ************************************************************************* //
