// SPDX-License-Identifier: GPL-3.0-or-later

#include "collectiveCalls.H"
#include "List.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <cstdio>
#include <cstring>
#include <unistd.h>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(collectiveCalls, 0);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Characters that a rank tells of its place
constexpr int width = 128;

// Tag of the messages, none of OpenFOAM's
constexpr int placeTag = 1912;

// A rank that does not come is waited for so long [ms]
constexpr label patience = 120000;


//- Ask at intervals whether the messages have come. -1, or the first rank from
//  which none has
label missingRank(const label nRanks, const label me, const label start)
{
    label missing = -1;
    for (label waited = 0; waited < patience; ++waited)
    {
        missing = -1;
        label request = start;
        for (label ranki = nRanks - 1; ranki >= 0; --ranki)
        {
            if (ranki != me && !UPstream::finishedRequest(request++))
            {
                missing = ranki;
            }
        }
        if (missing < 0)
        {
            break;
        }
        // The first ones come at once
        ::usleep(waited < 1000 ? 10 : 1000);
    }
    return missing;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::collectiveCalls::compare
(
    const callPlace& place,
    const label size,
    const label comm
)
{
    const label nRanks = UPstream::parRun() ? UPstream::nProcs(comm) : 1;
    if (nRanks == 1)
    {
        return;
    }
    const label me = UPstream::myProcNo(comm);
    const char* slash = std::strrchr(place.file, '/');
    const char* name = slash ? slash + 1 : place.file;
    List<char> told(nRanks*width, '\0');
    char* mine = told.data() + me*width;
    if (size < 0)
    {
        std::snprintf(mine, width, "%s:%d", name, place.line);
    }
    else
    {
        std::snprintf
        (
            mine, width, "%s:%d with %ld values", name, place.line, long(size)
        );
    }

    const auto how = UPstream::commsTypes::nonBlocking;
    const label start = UPstream::nRequests();
    for (label ranki = nRanks - 1; ranki >= 0; --ranki)
    {
        if (ranki != me)
        {
            char* theirs = told.data() + ranki*width;
            UIPstream::read(how, ranki, theirs, width, placeTag, comm);
        }
    }
    for (label ranki = 0; ranki < nRanks; ++ranki)
    {
        if (ranki != me)
        {
            UOPstream::write(how, ranki, mine, width, placeTag, comm);
        }
    }
    const label missing = missingRank(nRanks, me, start);
    if (missing >= 0)
    {
        FatalErrorInFunction
            << "Rank " << me << " waits in a collective call at " << mine
            << ", but rank " << missing << " does not come"
            << exit(FatalError);
    }
    UPstream::waitRequests(start);
    for (label ranki = 0; ranki < nRanks; ++ranki)
    {
        const char* theirs = told.cdata() + ranki*width;
        if (std::strncmp(theirs, mine, width) != 0)
        {
            FatalErrorInFunction
                << "Ranks make different collective calls: rank " << me
                << " at " << mine << ", rank " << ranki << " at " << theirs
                << exit(FatalError);
        }
    }
}


// ************************************************************************* //
