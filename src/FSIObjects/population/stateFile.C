// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateFile.H"
#include "entryPlaces.H"
#include "errorOf.H"
#include "localIOdictionary.H"
#include "openfoamFiles.H"
#include "openfoamVersion.H"
#include "SHA1.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

//- Entry with the sums of the others
static const Foam::word sumsName("checkSums");

static const char* const advice =
    "The file is damaged or was changed: restore it, start from another time,"
    " or run seedObjects";


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static word sumOf(const std::string& text)
{
    // With a letter in front, so that it is a word in a file
    return word(SHA1(text).digest().str(true));
}


//- An entry as it would be written
static std::string textOf(const entry& e)
{
    OStringStream os(IOstream::BINARY);
    os.precision(17);
    e.write(os);
    return os.str();
}


//- FatalIOError for the entry of a file
static void refuse
(
    const dictionary& dict,
    const word& key,
    const char* fault
)
{
    FatalIOErrorInFunction(dict)
        << "Entry '" << key << "' in file " << dict.name() << " " << fault
        << nl << advice
        << " (after a change on purpose, remove entry '" << sumsName << "')"
        << exit(FatalIOError);
}


//- Take the sums out of a dictionary and compare
static void compareSums(dictionary& dict)
{
    if (!dict.isDict(sumsName))
    {
        if (dict.found(sumsName))
        {
            refuse(dict, sumsName, "is no dictionary");
        }
        return;
    }
    const dictionary written(dict.subDict(sumsName));
    dict.remove(sumsName);
    const dictionary present(stateFile::sums(dict));
    for (const entry& e : written)
    {
        if (!present.found(e.keyword()))
        {
            refuse(dict, e.keyword(), "is missing");
        }
        if
        (
            e.isDict()
         || textOf(e) != textOf(entryOf(present, e.keyword()))
        )
        {
            refuse(dict, e.keyword(), "does not match its check sum");
        }
    }
    for (const entry& e : present)
    {
        if (!written.found(e.keyword()))
        {
            refuse(dict, e.keyword(), "has no check sum");
        }
    }
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
    return !foundPath(io).empty();
}


Foam::dictionary Foam::fsi::stateFile::sums(const dictionary& content)
{
    dictionary result;
    for (const entry& e : content)
    {
        if (e.keyword() != "FoamFile" && e.keyword() != sumsName)
        {
            result.set(e.keyword(), sumOf(textOf(e)));
        }
    }
    return result;
}


Foam::word Foam::fsi::stateFile::sum(const dictionary& content)
{
    std::string text;
    for (const entry& e : sums(content))
    {
        text += textOf(e);
    }
    return sumOf(text);
}


Foam::dictionary Foam::fsi::stateFile::read(const IOobject& io)
{
    const fileName found(foundPath(io));
    const fileName file(found.empty() ? fileName(pathOf(io)) : found);
    const entryPlaces places(file);
    word key(places.oversized());
    dictionary dict;
    caughtError error;
    if (key.empty())
    {
        error = errorOf([&]() { dict = dictionary(localIOdictionary(io)); });
        key = places.entryAt(error.line);
    }
    else
    {
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
    compareSums(dict);
    return dict;
}


// ************************************************************************* //
