// SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeRanks.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::rankIn(const label comm)
{
    return UPstream::parRun() ? UPstream::myProcNo(comm) : 0;
}


Foam::label Foam::fsi::nRanksIn(const label comm)
{
    return UPstream::parRun() ? UPstream::nProcs(comm) : 1;
}


void Foam::fsi::gatherToFirst
(
    const List<float>& part,
    List<float>& whole,
    const List<int>& sizes,
    const List<int>& offsets,
    const label comm,
    const callPlace& place
)
{
    collectiveCalls::check(place, sizes.size(), comm);
    UPstream::gather
    (
        reinterpret_cast<const char*>(part.cdata()),
        part.size()*sizeof(float),
        reinterpret_cast<char*>(whole.data()),
        sizes,
        offsets,
        comm
    );
}


void Foam::fsi::scatterFromFirst
(
    const List<float>& whole,
    List<float>& part,
    const List<int>& sizes,
    const List<int>& offsets,
    const label comm,
    const callPlace& place
)
{
    collectiveCalls::check(place, sizes.size(), comm);
    UPstream::scatter
    (
        reinterpret_cast<const char*>(whole.cdata()),
        sizes,
        offsets,
        reinterpret_cast<char*>(part.data()),
        part.size()*sizeof(float),
        comm
    );
}


// ************************************************************************* //
