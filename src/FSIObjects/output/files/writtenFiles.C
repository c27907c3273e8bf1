// SPDX-License-Identifier: GPL-3.0-or-later

#include "writtenFiles.H"
#include "diskNote.H"
#include "errorOf.H"
#include "IFstream.H"
#include "openfoamFiles.H"
#include "openfoamVersion.H"
#include "OSspecific.H"
#include "sumOverRanks.H"
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


//- Are the parts of all ranks in a file of the file handler collated whole?
static bool blocksEnd(std::ifstream& is)
{
    bool found = false;
    std::string line;
    while (std::getline(is, line))
    {
        if (line.compare(0, 12, "// Processor") == 0)
        {
            std::streamoff size = 0;
            char bracket = ' ';
            is >> size >> bracket;
            is.seekg(size, std::ios::cur);
            found = bracket == '(' && is.get() == ')';
            if (!found)
            {
                return false;
            }
        }
    }
    return found;
}


//- The file or dictionary that an error was in, and the line
static string placeOf(const caughtError& error)
{
    if (error.file.empty())
    {
        return string();
    }
    const string line(", line " + Foam::name(error.line));
    return " (" + error.file + (error.line < 0 ? string() : line) + ")";
}


//- Why the disk takes no more, if it does not, and the last complete time
static string endOfMessage(const Time& time)
{
    return diskNote(time.path()) + lastTimeNote(time.globalPath());
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
    if (text.find("*** //") != std::string::npos)
    {
        return true;
    }
    is.clear();
    is.seekg(0);
    text.resize(2000);
    is.read(&text[0], text.size());
    is.clear();
    is.seekg(0);
    return text.find("decomposedBlockData") < 2000 && blocksEnd(is);
}


Foam::fileName Foam::fsi::writtenFiles::fault
(
    const fileName& timeFolder,
    const wordList& fields
)
{
    for (const word& name : fields)
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


bool Foam::fsi::writtenFiles::holdsState(const fileName& timeFolder)
{
    const fileName folder(timeFolder/"uniform");
    for (const fileName& file : filesIn(folder))
    {
        if (file.find("fsi") == 0)
        {
            return true;
        }
    }
    return isDir(folder/"fsiObjects");
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
            << time.globalPath() << ": " << error.message.c_str()
            << placeOf(error).c_str() << nl << endOfMessage(time).c_str()
            << exit(FatalError);
    }
}


void Foam::fsi::writtenFiles::check(const Time& time)
{
    if (!time.writeTime())
    {
        return;
    }
    finishWriting();
    gatherOverRanks(true);
    const fileName folder(folderOf(time));
    fileName wrong(fault(folder, ofFirstRank(fieldsOf(folder))));
    const fileName state
    (
        folder/"uniform"/"functionObjects"/"functionObjectProperties"
    );
    if (wrong.empty() && writesFunctionState(time) && !isFile(state))
    {
        wrong = state;
    }
    if (!wrong.empty())
    {
        FatalErrorInFunction
            << "File " << wrong << " is missing or cut after it was written"
            << nl << endOfMessage(time).c_str() << exit(FatalError);
    }
}


// ************************************************************************* //
