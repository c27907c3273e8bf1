// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionaryCheck.H"
#include "errorOf.H"
#include "misspelling.H"
#include "OStringStream.H"
#include "openfoamTypes.H"
#include "openfoamVersion.H"
#include "userVariables.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Its powers still are numbers, in what is computed from it
static const scalar leastPositive = 1e-50;


//- Fatal unless the value of the key holds the condition
static scalar checked
(
    const dictionary& dict,
    const word& key,
    const scalar value,
    const bool valid,
    const char* condition
)
{
    // Written so that NaN fails as well
    if (!valid)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name()
            << " is " << value << " but must be " << condition
            << (value > 0 ? ", by at least 1e-50" : "")
            << exit(FatalIOError);
    }
    return value;
}


//- Does a pattern match a name?
static bool matchesAny(const keyType& pattern, const wordList& names)
{
    for (const word& name : names)
    {
        if (pattern.match(name))
        {
            return true;
        }
    }
    return false;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::checkKeys(const dictionary& dict, const wordList& known)
{
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();
        const bool isKnown =
            key.isPattern() ? matchesAny(key, known) : isIn(known, word(key));
        if (isKnown)
        {
            continue;
        }
        const word valid(meant(key, known));
        if
        (
            !key.isPattern()
         && (
                userVariables::has(dict, key)
             || (valid.empty() && userVariables::isCopied(dict, key))
            )
        )
        {
            continue;
        }
        FatalIOErrorInFunction(dict)
            << "Unknown entry '" << key << "' in dictionary " << dict.name();
        if (!valid.empty())
        {
            FatalIOError<< ": is " << valid << " meant?";
        }
        FatalIOError
            << nl << "Valid entries are " << flatOutput(known)
            << exit(FatalIOError);
    }
}


void Foam::fsi::checkSubDicts(const dictionary& dict, const wordList& keys)
{
    for (const word& key : keys)
    {
        if (dict.found(key) && !dict.isDict(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' in dictionary " << dict.name()
                << " must be a dictionary: " << key << " { .. }"
                << exit(FatalIOError);
        }
    }
}


const Foam::dictionary& Foam::fsi::dictOf
(
    const dictionary& dict,
    const entry& e,
    const word& what
)
{
    if (!e.isDict())
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << e.keyword() << "' in dictionary " << dict.name()
            << " must be the dictionary of a " << what << exit(FatalIOError);
    }
    return e.dict();
}


Foam::scalar Foam::fsi::readPositive
(
    const dictionary& dict,
    const word& key,
    const scalar defaultValue
)
{
    const scalar value = readEntryOr<scalar>(dict, key, defaultValue);
    return checked(dict, key, value, value >= leastPositive, "> 0");
}


Foam::scalar Foam::fsi::readPositive(const dictionary& dict, const word& key)
{
    const scalar value = readEntry<scalar>(dict, key);
    return checked(dict, key, value, value >= leastPositive, "> 0");
}


Foam::scalar Foam::fsi::readNonNegative
(
    const dictionary& dict,
    const word& key,
    const scalar defaultValue
)
{
    const scalar value = readEntryOr<scalar>(dict, key, defaultValue);
    return checked
    (
        dict, key, value, value == 0 || value >= leastPositive, ">= 0"
    );
}


Foam::label Foam::fsi::readAtLeast
(
    const dictionary& dict,
    const word& key,
    const label defaultValue,
    const label minimum
)
{
    const label value = readEntryOr<label>(dict, key, defaultValue);
    if (value < minimum)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " but must be >= " << minimum << exit(FatalIOError);
    }
    return value;
}


Foam::word Foam::fsi::readName(const dictionary& dict, const word& key)
{
    if (dict.found(key) && !dict.isDict(key))
    {
        const ITstream& is = dict.lookup(key);
        if (is.size() && is[0].isNumber())
        {
            OStringStream text;
            text << is[0];
            return word(text.str(), false);
        }
    }
    return readEntry<word>(dict, key);
}


Foam::word Foam::fsi::readName
(
    const dictionary& dict,
    const word& key,
    const word& defaultValue
)
{
    return dict.found(key) ? readName(dict, key) : defaultValue;
}


Foam::word Foam::fsi::readChoice
(
    const dictionary& dict,
    const word& key,
    const word& defaultValue,
    const wordList& choices
)
{
    const word value(readName(dict, key, defaultValue));
    if (!isIn(choices, value))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown choice '" << value << "' of entry '" << key
            << "' in dictionary " << dict.name() << nl
            << "Valid choices are " << flatOutput(choices)
            << exit(FatalIOError);
    }
    return value;
}


// ************************************************************************* //
