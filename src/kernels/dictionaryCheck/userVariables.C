// SPDX-License-Identifier: GPL-3.0-or-later

#include "userVariables.H"
#include "dictionaryCheck.H"
#include "IFstream.H"
#include "misspelling.H"
#include "openfoamVersion.H"
#include "OSspecific.H"

#include <cctype>
#include <regex>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace userVariables
{

//- A file's text without its comments. By hand: a regular expression over a
//  long comment needs a stack as long
static std::string textOf(const fileName& file)
{
    std::string all;
    IFstream is(file);
    for (string line; is.good(); all += line + '\n')
    {
        is.getLine(line);
    }
    std::string text;
    bool quoted = false;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const bool line = !quoted && all.compare(i, 2, "//") == 0;
        if (line || (!quoted && all.compare(i, 2, "/*") == 0))
        {
            const std::size_t end = all.find(line ? "\n" : "*/", i + 2);
            i = end == std::string::npos ? all.size() : end + !line;
            text += ' ';
            continue;
        }
        quoted = quoted != (all[i] == '"' && (i == 0 || all[i-1] != '\\'));
        text += all[i];
    }
    return text;
}


//- Add a variable as it stands behind its $, with a scope or not
static void addNames(const std::string& variable, wordHashSet& names)
{
    names.insert(word(variable, false));
    static const std::regex part("\\w+");
    std::sregex_iterator found(variable.begin(), variable.end(), part);
    for (; found != std::sregex_iterator(); ++found)
    {
        names.insert(word(found->str(), false));
    }
}


static void collect
(
    const fileName& file,
    const label depth,
    wordHashSet& names
)
{
    const std::string text(textOf(file));
    const std::sregex_iterator none;
    static const std::regex variable("\\$\\{*([^\\s;(){}\"$]{1,99})");
    std::sregex_iterator used(text.begin(), text.end(), variable);
    for (; used != none; ++used)
    {
        addNames((*used)[1], names);
    }
    static const std::regex include
    (
        "#\\s*s?include\\w*\\s+\"([^\"\n]{1,499})\""
    );
    std::sregex_iterator found(text.begin(), text.end(), include);
    for (; found != none && depth < 10; ++found)
    {
        fileName other((*found)[1].str());
        other.expand(true);
        other = other.isAbsolute() ? other : file.path()/other;
        if (isFile(other))
        {
            collect(other, depth + 1, names);
        }
    }
}


//- Has one of the dictionaries in this one, that is used, the key?
static bool usedHasKey
(
    const dictionary& dict,
    const wordHashSet& used,
    const word& key
)
{
    for (const entry& e : dict)
    {
        if
        (
            e.isDict()
         && (
                (used.found(e.keyword()) && e.dict().found(key))
             || usedHasKey(e.dict(), used, key)
            )
        )
        {
            return true;
        }
    }
    return false;
}


//- Does the text have the name as a whole word?
static bool hasWord(const std::string& text, const word& name)
{
    std::size_t start = text.find(name);
    for (; start != std::string::npos; start = text.find(name, start + 1))
    {
        const std::size_t end = start + name.size();
        if
        (
            (start == 0 || !std::isalnum(text[start - 1]))
         && (end == text.size() || !std::isalnum(text[end]))
        )
        {
            return true;
        }
    }
    return false;
}

} // End namespace userVariables
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::fsi::userVariables::fileOf(const dictionary& dict)
{
    // The name of a part is that of its file and its keys, separated by one
    // of .:/
    static const std::regex rank("/processors?[0-9][^/]*(?=/)");
    const std::string name(dict.name());
    for (const std::string& path : {name, std::regex_replace(name, rank, "")})
    {
        std::size_t end = path.size();
        for (; end != std::string::npos && end > 0;)
        {
            const fileName file(path.substr(0, end));
            if (isFile(file))
            {
                return file;
            }
            end = path.find_last_of(".:/", end - 1);
        }
    }
    return fileName();
}


Foam::wordHashSet Foam::fsi::userVariables::usedIn(const fileName& file)
{
    wordHashSet names;
    collect(file, 0, names);
    return names;
}


bool Foam::fsi::userVariables::has(const dictionary& dict, const word& name)
{
    static const std::regex state("/(constant|uniform)/fsi(Objects|Pop)");
    if (name == "FoamFile" || std::regex_search(dict.name(), state))
    {
        return true;
    }
    const fileName file(fileOf(dict));
    return !file.empty() && usedIn(file).found(name);
}


bool Foam::fsi::userVariables::isCopied
(
    const dictionary& dict,
    const word& key
)
{
    const fileName file(fileOf(dict));
    if (file.empty())
    {
        return false;
    }
    IFstream is(file);
    return usedHasKey(dictionary(is), usedIn(file), key);
}


bool Foam::fsi::userVariables::isAside
(
    const dictionary& dict,
    const entry& e,
    const wordList& keys
)
{
    bool whole = e.isDict();
    for (const word& key : keys)
    {
        whole = whole && e.dict().found(key);
    }
    return !whole && has(dict, e.keyword());
}


void Foam::fsi::userVariables::checkFileKeys
(
    const dictionary& dict,
    const wordList& known,
    const wordList& former
)
{
    wordList all(known);
    const fileName file(fileOf(dict));
    const std::string text(file.empty() ? std::string() : textOf(file));
    const wordHashSet used(usedIn(file));
    for (const entry& e : dict)
    {
        const word& name = e.keyword();
        if
        (
            e.keyword().isPattern() || isIn(known, name)
         || isIn(former, name) || !meant(name, known).empty()
        )
        {
            continue;
        }
        all.append(name);
        if (hasWord(text, name) && !used.found(name) && name != "FoamFile")
        {
            IOWarningInFunction(dict)
                << "Entry '" << name << "' in dictionary " << dict.name()
                << " has no effect: it is none of " << flatOutput(known)
                << ", and $" << name << " is not used" << nl << endl;
        }
    }
    checkKeys(dict, all);
}


// ************************************************************************* //
