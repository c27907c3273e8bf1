// SPDX-License-Identifier: GPL-3.0-or-later

#include "writtenFiles.H"
#include "argList.H"
#include "errorOf.H"
#include "IFstream.H"
#include "instantList.H"
#include "openfoamVersion.H"
#include "OSspecific.H"
#include "Time.H"

#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace writtenFiles
{

//- The fields of a time that was written with its list; those without are
//  listed as p
static wordList fieldsOf(const fileName& timeFolder)
{
    const fileName list(timeFolder/"uniform"/"fsiRestart");
    wordList fields(1, word("p"));
    if (isFile(list, false))
    {
        errorOf
        (
            [&]()
            {
                IFstream is(list);
                fields = getEntry<wordList>(dictionary(is), "fields");
            }
        );
    }
    return fields;
}


//- Folders of the case's ranks; the case itself if there are none
static fileNameList rankFolders(const fileName& caseFolder)
{
    DynamicList<fileName> folders;
    for (label i = 0; isDir(caseFolder/("processor" + Foam::name(i))); ++i)
    {
        folders.append(caseFolder/("processor" + Foam::name(i)));
    }
    if (folders.empty())
    {
        folders.append(caseFolder);
    }
    return fileNameList(folders);
}


//- Does controlDict ask for the latest time
static bool startsFromLatest(const fileName& caseFolder)
{
    word start;
    errorOf
    (
        [&]()
        {
            IFstream is(caseFolder/"system"/"controlDict");
            start = getEntry<word>(dictionary(is), "startFrom");
        }
    );
    return start == "latestTime";
}

} // End namespace writtenFiles
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::fsi::writtenFiles::hasEnd(const fileName& file)
{
    if (file.ext() == "gz")
    {
        return true;
    }
    std::ifstream is(file, std::ios::binary);
    std::string text(20, ' ');
    is.read(&text[0], text.size());
    if (is.gcount() == 0)
    {
        return false;
    }
    if (text.compare(0, 10, "/*--------") != 0)
    {
        return true;
    }
    is.seekg(-20, std::ios::end);
    is.read(&text[0], text.size());
    return text.find("*** //") != std::string::npos;
}


Foam::fileName Foam::fsi::writtenFiles::fault
(
    const fileName& timeFolder,
    const bool all
)
{
    const wordList names(all ? fieldsOf(timeFolder) : wordList(1, word("p")));
    for (const word& name : names)
    {
        if (!isFile(timeFolder/name))
        {
            return timeFolder/name;
        }
    }
    for
    (
        const char* local :
        {"", "uniform", "uniform/fsiObjects", "uniform/functionObjects"}
    )
    {
        const fileName folder(timeFolder/fileName(local));
        for (const fileName& file : filesIn(folder))
        {
            if (!hasEnd(folder/file))
            {
                return folder/file;
            }
        }
    }
    return fileName();
}


Foam::word Foam::fsi::writtenFiles::lastTime(const fileName& caseFolder)
{
    const fileNameList ranks(rankFolders(caseFolder));
    const instantList times(timesIn(ranks[0]));
    for (label i = times.size() - 1; i >= 0; --i)
    {
        bool complete = times[i].name() != "constant";
        for (const fileName& rank : ranks)
        {
            complete = complete && fault(rank/times[i].name(), false).empty();
        }
        if (complete)
        {
            return times[i].name();
        }
    }
    return word();
}


Foam::string Foam::fsi::writtenFiles::lastTimeNote(const fileName& caseFolder)
{
    const word last(lastTime(caseFolder));
    return
        last.empty()
      ? string("No time is complete")
      : string("The last complete time is " + last);
}


void Foam::fsi::writtenFiles::write
(
    Time& time,
    const std::function<void()>& writeOthers
)
{
    const caughtError error = errorOf
    (
        [&]()
        {
            writeOthers();
            time.write();
        }
    );
    if (!error.message.empty())
    {
        FatalErrorInFunction
            << "Cannot write time " << nameOf(time) << " of "
            << time.globalPath() << ": " << error.message.c_str() << nl
            << "Is the disk full? "
            << lastTimeNote(time.globalPath()).c_str() << exit(FatalError);
    }
}


void Foam::fsi::writtenFiles::check(const Time& time)
{
    if (!time.writeTime())
    {
        return;
    }
    fileName wrong(fault(time.timePath(), true));
    const fileName state
    (
        time.timePath()/"uniform"/"functionObjects"/"functionObjectProperties"
    );
    if (wrong.empty() && writesFunctionState(time) && !isFile(state))
    {
        wrong = state;
    }
    if (!wrong.empty())
    {
        FatalErrorInFunction
            << "File " << wrong << " is missing or cut after it was written."
            << " Is the disk full?" << nl
            << lastTimeNote(time.globalPath()).c_str() << exit(FatalError);
    }
}


void Foam::fsi::writtenFiles::setAside(const argList& args)
{
    const fileName caseFolder(args.rootPath()/args.globalCaseName());
    if (Pstream::master() && startsFromLatest(caseFolder))
    {
        const word last(lastTime(caseFolder));
        for (const fileName& rank : rankFolders(caseFolder))
        {
            const instantList times(timesIn(rank));
            for (label i = times.size() - 1; i > 0; --i)
            {
                if (last.empty() || times[i].name() == last)
                {
                    break;
                }
                const fileName folder(rank/times[i].name());
                WarningInFunction
                    << "Time " << times[i].name() << " is incomplete: its run"
                    << " ended while it was written. " << folder
                    << " is renamed to " << times[i].name() << ".incomplete, "
                    << "and the run starts from " << last << nl << endl;
                const fileName target(folder + ".incomplete");
                if (isDir(target))
                {
                    rmDir(target);
                }
                mv(folder, target);
            }
        }
    }
    // The others wait for the renamed folders
    bool done = true;
    Pstream::scatter(done);
}


// ************************************************************************* //
