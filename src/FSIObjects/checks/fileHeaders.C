// SPDX-License-Identifier: GPL-3.0-or-later

#include "fileHeaders.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "OSspecific.H"

#include <cstdlib>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace fileHeaders
{

//- Number behind the word version of a file's header, 2 if there is none
static double versionOf(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::string text(4000, ' ');
    is.read(&text[0], text.size());
    text.resize(is.gcount());

    const std::string key("version");
    const std::size_t header = text.find("FoamFile");
    const std::size_t found =
        header == std::string::npos ? header : text.find(key, header);
    if (found == std::string::npos || found > text.find('}', header))
    {
        return 2;
    }
    return std::strtod(text.c_str() + found + key.size(), nullptr);
}

} // End namespace fileHeaders
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::fileHeaders::check(const fileName& folder)
{
    for (const fileName& name : filesIn(folder))
    {
        const double version = versionOf(folder/name);
        if (!isUsable(version) || version < 0 || version > 100)
        {
            FatalErrorInFunction
                << "Entry 'version' in the header of file " << folder/name
                << " is " << version << ": OpenFOAM's is 2.0"
                << exit(FatalError);
        }
    }
}


// ************************************************************************* //
