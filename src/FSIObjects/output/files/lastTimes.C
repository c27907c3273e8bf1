// SPDX-License-Identifier: GPL-3.0-or-later

#include "writtenFiles.H"
#include "argList.H"
#include "errorOf.H"
#include "IFstream.H"
#include "instantList.H"
#include "noTraps.H"
#include "openfoamVersion.H"
#include "OSspecific.H"
#include "sumOverRanks.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace writtenFiles
{

//- Folders that have parts of the same times: those of the case's ranks,
//  processor0 and so on, and of each number of ranks those that have the files
//  of several, processors4 or processors4_0-1; the case itself if there are
//  none
static List<fileNameList> rankFolders(const fileName& caseFolder)
{
    HashTable<DynamicList<fileName>> sets;
    for (label i = 0; isDir(caseFolder/("processor" + Foam::name(i))); ++i)
    {
        sets("").append(caseFolder/("processor" + Foam::name(i)));
    }
    for (const fileName& folder : foldersIn(caseFolder))
    {
        if (folder.find("processors") == 0)
        {
            sets(folder.substr(0, folder.find('_'))).append(caseFolder/folder);
        }
    }
    List<fileNameList> result;
    for (const word& set : sets.sortedToc())
    {
        result.append(fileNameList(sets[set]));
    }
    if (result.empty())
    {
        result.append(fileNameList(1, caseFolder));
    }
    return result;
}


//- Times in a folder, in their order. Not by the file handler, which may want
//  all ranks for it
static instantList timesOnDisk(const fileName& folder)
{
    const noTraps untrapped;
    instantList times;
    for (const fileName& name : foldersIn(folder))
    {
        scalar value = 0;
        if (readScalar(name.c_str(), value))
        {
            times.append(instant(value, word(name)));
        }
    }
    Foam::sort(times);
    return times;
}


//- Does any of some folders hold the objects' state at a time?
static bool anyHoldsState(const fileNameList& folders, const word& time)
{
    bool any = false;
    for (const fileName& folder : folders)
    {
        any = any || holdsState(folder/time);
    }
    return any;
}


//- The last time that is complete in all folders
static instant lastComplete(const fileNameList& folders)
{
    const instantList times(timesOnDisk(folders[0]));
    for (label i = times.size() - 1; i >= 0; --i)
    {
        bool complete = anyHoldsState(folders, times[i].name());
        for (const fileName& folder : folders)
        {
            complete =
                complete
             && fault(folder/times[i].name(), wordList(1, word("p"))).empty();
        }
        if (complete)
        {
            return times[i];
        }
    }
    return instant(-GREAT, word());
}


//- The last time that is complete in the folders of any set
static instant lastOf(const fileName& caseFolder)
{
    instant last(-GREAT, word());
    for (const fileNameList& folders : rankFolders(caseFolder))
    {
        const instant ofSet(lastComplete(folders));
        if (ofSet.value() > last.value())
        {
            last = ofSet;
        }
    }
    return last;
}


//- Rename the folders of an incomplete time
static void rename
(
    const fileNameList& folders,
    const word& name,
    const word& last
)
{
    for (const fileName& folder : folders)
    {
        if (!isDir(folder/name))
        {
            continue;
        }
        WarningInFunction
            << "Time " << name << " is incomplete: its run ended while it was"
            << " written. " << folder/name << " is renamed to " << name
            << ".incomplete, and the run starts from " << last << nl << endl;
        const fileName target(folder/name + ".incomplete");
        if (isDir(target))
        {
            rmDir(target);
        }
        mv(folder/name, target);
    }
}


//- Warn of a time that has the flow, but nothing of the objects' state
static void warnWithoutState
(
    const fileName& folder,
    const word& time,
    const word& last
)
{
    if (isFile(folder/time/"U"))
    {
        WarningInFunction
            << "Time " << time << " of " << folder << " has the velocity,"
            << " but not the objects' state (uniform/fsi*). The run starts"
            << " from " << last << nl << endl;
    }
}


//- Rename the times of folders that are later than the last complete one. True
//  if some of them stay, since they are those of function objects
static bool setAsideAfter(const instant& last, const fileNameList& folders)
{
    bool stay = false;
    for (const fileName& folder : folders)
    {
        for (const instant& time : timesOnDisk(folder))
        {
            if (time.value() <= last.value())
            {
                continue;
            }
            if (anyHoldsState(folders, time.name()))
            {
                rename(folders, time.name(), last.name());
            }
            else
            {
                warnWithoutState(folder, time.name(), last.name());
                stay = true;
            }
        }
    }
    return stay;
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

Foam::fileName Foam::fsi::writtenFiles::folderOf(const Time& time)
{
    const fileName own(time.timePath());
    if (!isDir(own) && severalRanks())
    {
        for (const fileNameList& folders : rankFolders(time.globalPath()))
        {
            if (isDir(folders[0]/nameOf(time)))
            {
                return folders[0]/nameOf(time);
            }
        }
    }
    return own;
}


Foam::word Foam::fsi::writtenFiles::lastTime(const fileName& caseFolder)
{
    return lastOf(caseFolder).name();
}


Foam::string Foam::fsi::writtenFiles::lastTimeNote(const fileName& caseFolder)
{
    const word last(lastTime(caseFolder));
    return
        last.empty()
      ? string("No time is complete")
      : string("The last complete time is " + last);
}


Foam::word Foam::fsi::writtenFiles::setAside(const argList& args)
{
    const fileName caseFolder(args.rootPath()/args.globalCaseName());
    word start;
    if (Pstream::master() && startsFromLatest(caseFolder))
    {
        const instant last(lastOf(caseFolder));
        bool stay = false;
        if (!last.name().empty())
        {
            for (const fileNameList& folders : rankFolders(caseFolder))
            {
                stay = setAsideAfter(last, folders) || stay;
            }
        }
        start = stay ? last.name() : word();
    }
    // The others wait for the renamed folders
    return gatherOverRanks(start)[0];
}


// ************************************************************************* //
