// SPDX-License-Identifier: GPL-3.0-or-later

#include "swapLists.H"
#include "exchangeBytes.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarList Foam::fsi::exchangeLists
(
    const UList<scalar>& sent,
    const labelUList& sentSizes,
    const labelUList& receivedSizes
)
{
    // In bytes
    const label n = sentSizes.size();
    List<int> put(n), take(n);
    for (label ranki = 0; ranki < n; ++ranki)
    {
        put[ranki] = sizeof(scalar)*sentSizes[ranki];
        take[ranki] = sizeof(scalar)*receivedSizes[ranki];
    }
    const List<int> putStarts(startsOf(put)), takeStarts(startsOf(take));
    scalarList received(takeStarts[n]/sizeof(scalar));
    exchangeBytes
    (
        reinterpret_cast<const char*>(sent.cdata()), put, putStarts,
        reinterpret_cast<char*>(received.data()), take, takeStarts,
        UPstream::worldComm
    );
    return received;
}


Foam::List<Foam::scalarList> Foam::fsi::swapLists
(
    const UList<DynamicList<scalar>>& sent,
    const labelUList& receivedSizes
)
{
    labelList sentSizes(sent.size());
    DynamicList<scalar> packed;
    forAll(sent, ranki)
    {
        sentSizes[ranki] = sent[ranki].size();
        packed.append(sent[ranki]);
    }
    const scalarList all(exchangeLists(packed, sentSizes, receivedSizes));
    List<scalarList> received(sent.size());
    label start = 0;
    forAll(received, ranki)
    {
        received[ranki] = SubList<scalar>(all, receivedSizes[ranki], start);
        start += receivedSizes[ranki];
    }
    return received;
}


Foam::List<Foam::scalarList> Foam::fsi::swapLists
(
    const UList<DynamicList<scalar>>& sent,
    const boolList& partner
)
{
    // Each tells how much comes, then sends it
    List<DynamicList<scalar>> counts(sent.size());
    labelList sizes(sent.size(), Zero);
    forAll(sent, ranki)
    {
        if (partner[ranki])
        {
            counts[ranki].append(sent[ranki].size());
            sizes[ranki] = 1;
        }
    }
    const List<scalarList> theirs(swapLists(counts, sizes));
    forAll(sizes, ranki)
    {
        if (partner[ranki])
        {
            sizes[ranki] = label(theirs[ranki][0]);
        }
    }
    return swapLists(sent, sizes);
}


// ************************************************************************* //
