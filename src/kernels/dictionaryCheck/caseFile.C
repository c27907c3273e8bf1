// SPDX-License-Identifier: GPL-3.0-or-later

#include "caseFile.H"
#include "IFstream.H"
#include "openfoamVersion.H"
#include "OSspecific.H"

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A name with its blanks
static fileName asItIs(const std::string& text)
{
    fileName name;
    name.assign(text);
    return name;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::caseFile::caseFile(const dictionary& dict, const word& key)
:
    dict_(dict),
    key_(key)
{
    // OpenFOAM's reader of file names ends the program at a blank
    ITstream& tokens = dict.lookup(key);
    const token value(tokens);
    if (!value.isString() && !value.isWord())
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name()
            << " must be the name of a file, in quotes" << exit(FatalIOError);
    }
    string text(value.isWord() ? value.wordToken() : value.stringToken());

    // The Foundation's expand() does not know this name
    const std::string inCase("<case>/");
    if (text.compare(0, inCase.size(), inCase) == 0)
    {
        text.erase(0, inCase.size());
    }
    text.expand();
    const string folder(getEnv("FOAM_CASE"));
    if (folder.size() && (text.empty() || text[0] != '/'))
    {
        text = folder + "/" + text;
    }
    name_ = asItIs(text);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::caseFile::fail(const std::string& reason) const
{
    FatalIOErrorInFunction(dict_)
        << "Entry '" << key_ << "' in dictionary " << dict_.name() << ": "
        << name_.c_str() << reason.c_str() << exit(FatalIOError);

    // For the compiler, which does not know that exit() does not return
    std::abort();
}


std::string Foam::fsi::caseFile::ending() const
{
    std::string name(name_);
    if (name.size() > 3 && name.compare(name.size() - 3, 3, ".gz") == 0)
    {
        name.resize(name.size() - 3);
    }
    const std::size_t dot = name.find_last_of("./");
    if (dot == std::string::npos || name[dot] != '.')
    {
        return "";
    }
    name.erase(0, dot + 1);
    for (char& c : name)
    {
        c = std::tolower(static_cast<unsigned char>(c));
    }
    return name;
}


std::string Foam::fsi::caseFile::text() const
{
    // OpenFOAM's stream unpacks NAME.gz where there is no NAME, but ends the
    // program at a blank in it
    const std::size_t n = name_.size();
    const bool ends = n > 3 && name_.compare(n - 3, 3, ".gz") == 0;
    const fileName plain(asItIs(name_.substr(0, ends ? n - 3 : n)));
    const bool packed =
        !isFile(plain, false) && isFile(asItIs(plain + ".gz"), false);
    if (!packed && (ends || !isFile(plain, false)))
    {
        fail
        (
            ends && isFile(plain, false)
          ? " cannot be read: the same file is there without .gz"
          : " cannot be read: there is no such file"
        );
    }
    if (packed && plain.find(' ') != std::string::npos)
    {
        fail(" cannot be read: unpack it, or name it without a blank");
    }
    std::ifstream file(plain, std::ios::binary);
    std::unique_ptr<IFstream> unpacked;
    if (packed)
    {
        unpacked.reset(new IFstream(plain));
    }
    std::string all
    (
        std::istreambuf_iterator<char>
        (
            packed ? unpacked->stdStream() : static_cast<std::istream&>(file)
        ),
        std::istreambuf_iterator<char>()
    );
    if (all.empty())
    {
        fail(" cannot be read, or is empty");
    }
    return all;
}


// ************************************************************************* //
