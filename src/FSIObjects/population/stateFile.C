// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateFile.H"
#include "contentSum.H"
#include "errorOf.H"
#include "IFstream.H"
#include "latticeRanks.H"
#include "localIOdictionary.H"
#include "openfoamFiles.H"
#include "openfoamVersion.H"
#include "stateText.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

//- Entry with the sum of what is before it
static const Foam::word sumName("checkSum");


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


//- FatalError for an entry of a file, or for all of it
static void refuse
(
    const fileName& file,
    const word& key,
    const std::string& fault
)
{
    FatalErrorInFunction
        << "Cannot read "
        << (key.empty() ? "" : "entry '" + key + "' in ").c_str()
        << "file " << file << ": " << fault.c_str() << nl
        << "The file is damaged or was changed: restore it, start from another"
        << " time, or run seedObjects (after a change on purpose, remove entry"
        << " '" << sumName << "')" << exit(FatalError);
}


//- Refuse a file that does not match its sum, or claims to have long lists
static void check(const fileName& file)
{
    const std::string text(textOf(file));
    const std::size_t end = text.rfind('\n' + sumName);
    if (end != std::string::npos)
    {
        std::string key, written;
        entryAt(text, end + 1) >> key >> written;
        if (written != contentSum::of(text, end + 1) + ';')
        {
            refuse(file, sumName, "it is not that of the file's content");
        }
    }
    const word key(oversized(text));
    if (!key.empty())
    {
        refuse(file, key, "a list has more values than the file can hold");
    }
}


//- Read a file on this rank
static dictionary readHere(const IOobject& io, const fileName& file)
{
    check(file);
    dictionary dict;
    word key("FoamFile");
    const caughtError error = errorOf
    (
        [&]()
        {
            IFstream is(file);
            if (!IOobject(io).readHeader(is))
            {
                FatalIOErrorInFunction(is) << "no header" << exit(FatalIOError);
            }
            dict.name() = file;
            bool more = true;
            while (more)
            {
                token first(is);
                key = first.isWord() ? first.wordToken() : key;
                is.putBack(first);
                more = !is.eof() && entry::New(dict, is);
            }
        }
    );
    if (!error.message.empty())
    {
        refuse(file, key, error.message);
    }
    dict.remove(sumName);
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


Foam::dictionary Foam::fsi::stateFile::readOnFirst(const IOobject& io)
{
    const fileName found(foundPath(io));
    const fileName file(found.empty() ? fileName(pathOf(io)) : found);
    return rankIn() == 0 ? readHere(io, file) : dictionary();
}


Foam::dictionary Foam::fsi::stateFile::read(const IOobject& io)
{
    dictionary all(readOnFirst(io));
    if (nRanksIn() == 1)
    {
        return all;
    }

    // Entry by entry: a message has less than 2 GiB
    dictionary dict;
    dict.name() = ofFirstRank(fileName(all.name()));
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
