// SPDX-License-Identifier: GPL-3.0-or-later

#include "fileHeaders.H"
#include "errorOf.H"
#include "noTraps.H"
#include "openfoamVersion.H"
#include "OSspecific.H"

#include <algorithm>
#include <cstdlib>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace fileHeaders
{

//- The first and the last characters of a file, where a field's entries are
static std::string endsOf(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::string text(4000, ' ');
    is.read(&text[0], text.size());
    text.resize(is.gcount());
    if (is)
    {
        is.seekg(0, std::ios::end);
        const std::streamoff rest(is.tellg() - std::streamoff(text.size()));
        std::string end(std::min<std::streamoff>(rest, 20000), ' ');
        is.seekg(-std::streamoff(end.size()), std::ios::end);
        is.read(&end[0], end.size());
        text += end;
    }
    return text;
}


//- Number behind the word version of a file's header, 2 if there is none
static double versionOf(const std::string& text)
{
    const std::string key("version");
    const std::size_t header = text.find("FoamFile");
    const std::size_t found =
        header == std::string::npos ? header : text.find(key, header);
    if (found == std::string::npos || found > text.find('}', header))
    {
        return 2;
    }
    const noTraps untrapped;
    return std::strtod(text.c_str() + found + key.size(), nullptr);
}


//- Is an entry a dictionary in one of its places?
static bool isDictionary(const std::string& text, const std::string& key)
{
    const std::string line('\n' + key);
    for
    (
        std::size_t found = text.find(line);
        found != std::string::npos;
        found = text.find(line, found + 1)
    )
    {
        const std::size_t value =
            text.find_first_not_of(" \t\r\n", found + line.size());
        if (value != std::string::npos && text[value] == '{')
        {
            return true;
        }
    }
    return false;
}

} // End namespace fileHeaders
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::fileHeaders::check(const fileName& folder)
{
    for (const fileName& name : filesIn(folder))
    {
        const std::string text(endsOf(folder/name));
        const double version = versionOf(text);
        if (!isUsable(version) || version < 0 || version > 100)
        {
            FatalErrorInFunction
                << "Entry 'version' in the header of file " << folder/name
                << " is " << version << ": OpenFOAM's is 2.0"
                << exit(FatalError);
        }
        for (const char* key : {"dimensions", "internalField"})
        {
            if (isDictionary(text, key))
            {
                FatalErrorInFunction
                    << "Entry '" << key << "' in file " << folder/name
                    << " is a dictionary: it must be the value of a field"
                    << exit(FatalError);
            }
        }
    }
}


// ************************************************************************* //
