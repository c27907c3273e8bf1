// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateFile.H"
#include "contentSum.H"
#include "entryPlaces.H"
#include "errorOf.H"
#include "IFstream.H"
#include "latticeRanks.H"
#include "localIOdictionary.H"
#include "openfoamFiles.H"
#include "openfoamVersion.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

//- Entry with the sum of what is before it
static const Foam::word sumName("checkSum");

static const char* const advice =
    "The file is damaged or was changed: restore it, start from another time,"
    " or run seedObjects";


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The whole of a file, compressed or not
static std::string textOf(const fileName& file)
{
    IFstream is(file);
    std::string text;
    if (is.good())
    {
        std::vector<char> block(1 << 20);
        do
        {
            is.stdStream().read(block.data(), block.size());
            text.append(block.data(), is.stdStream().gcount());
        }
        while (is.stdStream());
    }
    return text;
}


//- Take the sum out of a dictionary and compare it with that of the file
static void compareSum(dictionary& dict, const word& present)
{
    if (!dict.found(sumName))
    {
        return;
    }
    const bool same =
        !dict.isDict(sumName) && readEntry<word>(dict, sumName) == present;
    dict.remove(sumName);
    if (!same)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << sumName << "' in file " << dict.name()
            << " does not match the file's content" << nl << advice
            << " (after a change on purpose, remove entry '" << sumName << "')"
            << exit(FatalIOError);
    }
}


//- Read a file on this rank
static dictionary readHere(const IOobject& io, const fileName& file)
{
    word key, sum;
    autoPtr<entryPlaces> places;
    {
        const std::string text(textOf(file));
        places.reset(new entryPlaces(text));
        const std::size_t end = text.rfind('\n' + sumName);
        sum = contentSum::of(text, end == std::string::npos ? 0 : end + 1);
    }
    dictionary dict;
    caughtError error;
    if (places->oversized().empty())
    {
        error = errorOf
        (
            [&]()
            {
                IFstream is(file);
                if (!IOobject(io).readHeader(is))
                {
                    FatalIOErrorInFunction(is)
                        << "There is no header" << exit(FatalIOError);
                }
                is >> dict;
            }
        );
        key = places->entryAt(error.line);
    }
    else
    {
        key = places->oversized();
        error.message = "a list has more values than the file can hold";
    }
    if (!error.message.empty())
    {
        FatalErrorInFunction
            << "Cannot read "
            << (key.empty() ? "" : "entry '" + key + "' in ").c_str()
            << "file " << file
            << ": " << error.message.c_str() << nl << advice
            << exit(FatalError);
    }
    compareSum(dict, sum);
    return dict;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::fsi::stateFile::input
(
    const Time& time,
    const fileName& instance,
    const fileName& local,
    const word& name
)
{
    return IOobject
    (
        name, instance, local, time,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
}


bool Foam::fsi::stateFile::exists(const IOobject& io)
{
    return ofFirstRank(!foundPath(io).empty());
}


Foam::dictionary Foam::fsi::stateFile::read(const IOobject& io)
{
    const fileName found(foundPath(io));
    const fileName file
    (
        ofFirstRank(found.empty() ? fileName(pathOf(io)) : found)
    );
    dictionary all;
    if (rankIn() == 0)
    {
        all = readHere(io, file);
    }
    if (nRanksIn() == 1)
    {
        return all;
    }

    // Entry by entry: a message has less than 2 GiB
    dictionary dict;
    dict.name() = file;
    const wordList keys(ofFirstRank(all.toc()));
    for (const word& key : keys)
    {
        dictionary one;
        if (rankIn() == 0)
        {
            one.add(entryOf(all, key));
            all.remove(key);
        }
        dict.merge(ofFirstRank(one));
    }
    return dict;
}


Foam::dictionary Foam::fsi::readState(const Time& time, const word& name)
{
    const IOobject io
    (
        stateFile::input(time, nameOf(time), "uniform", name)
    );
    return stateFile::exists(io) ? stateFile::read(io) : dictionary();
}


void Foam::fsi::writeFile
(
    const Time& time,
    const fileName& instance,
    const fileName& local,
    const word& name,
    const IOstream::streamFormat format,
    const std::function<void(Ostream&)>& writer
)
{
    if (rankIn() > 0)
    {
        return;
    }
    const IOobject io(stateFile::input(time, instance, local, name));
    autoPtr<OFstream> file
    (
        newFile
        (
            io,
            format,
            format == IOstream::ASCII
          ? time.writeCompression()
          : IOstream::UNCOMPRESSED
        )
    );
    OFstream& os = file();
    std::ostream& stream = os.stdStream();
    std::streambuf* const target = stream.rdbuf();
    contentSum sum(*target);
    stream.rdbuf(&sum);
    io.writeHeader(os, IOdictionary::typeName);
    // All bits of the numbers
    os.precision(17);
    writer(os);
    const bool good = os.good();
    stream.rdbuf(target);

    putEntry(os, sumName, sum.value());
    IOobject::writeEndDivider(os);
    os.flush();
    if (!good || !os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << os.name() << exit(FatalError);
    }
}


// ************************************************************************* //
