// SPDX-License-Identifier: GPL-3.0-or-later

#include "caseLock.H"
#include "error.H"
#include "Pstream.H"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

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
    if (folder_ >= 0 && ::flock(folder_, LOCK_EX | LOCK_NB) != 0)
    {
        if (errno == EWOULDBLOCK)
        {
            FatalErrorInFunction
                << "Another run works in " << folder
                << ": wait for its end, or copy the case"
                << exit(FatalError);
        }
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
