// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateFile.H"
#include "contentSum.H"
#include "errorOf.H"
#include "IFstream.H"
#include "latticeRanks.H"
#include "localIOdictionary.H"
#include "openfoamFiles.H"
#include "openfoamVersion.H"
#include "Time.H"

#include <cctype>
#include <cstdlib>
#include <sstream>

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


//- Words of the last line until a place of a text that begins with a letter,
//  where an entry begins
static std::istringstream entryAt(const std::string& text, std::size_t place)
{
    std::size_t start = text.rfind('\n', place);
    while
    (
        start != std::string::npos && start > 0
     && !std::isalpha(static_cast<unsigned char>(text[start + 1]))
    )
    {
        start = text.rfind('\n', start - 1);
    }
    const std::size_t end = text.find('\n', start + 1);
    return std::istringstream(text.substr(start + 1, end - start - 1));
}


//- The entry of a list that would have more values than its file can hold:
//  noticed before memory is asked for; empty if there is none
static word oversized(const std::string& text)
{
    static const char* const blanks = " \t\r\n";
    const bool binary = text.find("binary") < text.find('}');
    std::size_t at = text.find_first_of("({");
    for (; at != std::string::npos; at = text.find_first_of("({", at + 1))
    {
        // A number in a list of lists is a value, and among the bytes of
        // numbers only what has the type of a list counts
        const std::size_t end = text.find_last_not_of(blanks, at - 1);
        const std::size_t before = text.find_last_of(" \t\r\n(){};>", end);
        const std::size_t type = text.find_last_not_of(blanks, before);
        if (at == 0 || before >= end || type > before)
        {
            continue;
        }
        const bool negative = text[before + 1] == '-';
        const std::size_t digits = before + 1 + negative;
        const scalar n = std::strtod(text.c_str() + digits, nullptr);
        const scalar most = (text[at] == '{' ? 1000.0 : 1.0)*text.size();
        if
        (
            text.find_first_not_of("0123456789", digits) > end
         && (n > most || negative) && text[type] != '(' && text[type] != ')'
         && (!binary || text[type] == '>')
        )
        {
            std::string key;
            entryAt(text, before) >> key;
            return word(key);
        }
    }
    return word();
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
