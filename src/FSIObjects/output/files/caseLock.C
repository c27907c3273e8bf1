// SPDX-License-Identifier: GPL-3.0-or-later

#include "caseLock.H"
#include "error.H"
#include "Pstream.H"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Tenths of a second that a lock is waited for
static const label patience = 50;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::caseLock::caseLock(const fileName& folder)
:
    folder_(-1)
{
    if (!Pstream::master())
    {
        return;
    }
    folder_ = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
    for (label tries = 0; folder_ >= 0; ++tries)
    {
        if (::flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
        {
            break;
        }
        if (tries == patience)
        {
            FatalErrorInFunction
                << "Another run works in " << folder
                << ": wait for its end, or copy the case"
                << exit(FatalError);
        }
        ::usleep(100000);
    }
}


Foam::fsi::caseLock::~caseLock()
{
    if (folder_ >= 0)
    {
        ::close(folder_);
    }
}


// ************************************************************************* //
