// SPDX-License-Identifier: GPL-3.0-or-later

#include "diskNote.H"
#include "OSspecific.H"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Number of the system's error when a file of 1 MiB is written; 0 for none
static int errorOfTrial(const fileName& file)
{
    const std::vector<char> block(1 << 20, '0');
    errno = 0;
    std::FILE* const os = std::fopen(file.c_str(), "wb");
    if (!os)
    {
        return errno;
    }
    const bool good =
        std::fwrite(block.data(), 1, block.size(), os) == block.size();
    const int fault = good ? 0 : errno;
    const bool closed = std::fclose(os) == 0;
    const int faultAtEnd = closed ? 0 : errno;
    std::remove(file.c_str());
    return good ? faultAtEnd : fault;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsi::diskNote(const fileName& folder)
{
    const word trial("fsiTrial" + std::to_string(pid()));
    const int fault = errorOfTrial(folder/trial);
    return
        fault == 0
      ? string()
      : string(folder + " takes no more data: " + std::strerror(fault) + '\n');
}


// ************************************************************************* //
