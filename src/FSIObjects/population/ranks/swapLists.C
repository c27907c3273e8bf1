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
    List<int> put(n), take(n), putStarts(n + 1, 0), takeStarts(n + 1, 0);
    for (label ranki = 0; ranki < n; ++ranki)
    {
        put[ranki] = sizeof(scalar)*sentSizes[ranki];
        take[ranki] = sizeof(scalar)*receivedSizes[ranki];
        putStarts[ranki + 1] = putStarts[ranki] + put[ranki];
        takeStarts[ranki + 1] = takeStarts[ranki] + take[ranki];
    }
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
    const boolList& partner
)
{
    // Each tells how much comes, then sends it
    const label n = partner.size();
    labelList one(n), sentSizes(n), receivedSizes(n, Zero);
    DynamicList<scalar> counts, packed;
    for (label ranki = 0; ranki < n; ++ranki)
    {
        one[ranki] = partner[ranki];
        sentSizes[ranki] = sent[ranki].size();
        packed.append(sent[ranki]);
        if (partner[ranki])
        {
            counts.append(sentSizes[ranki]);
        }
    }
    const scalarList theirs(exchangeLists(counts, one, one));
    label next = 0;
    for (label ranki = 0; ranki < n; ++ranki)
    {
        if (partner[ranki])
        {
            receivedSizes[ranki] = label(theirs[next++]);
        }
    }
    const scalarList all(exchangeLists(packed, sentSizes, receivedSizes));
    List<scalarList> received(n);
    label start = 0;
    forAll(received, ranki)
    {
        received[ranki] = SubList<scalar>(all, receivedSizes[ranki], start);
        start += receivedSizes[ranki];
    }
    return received;
}


// ************************************************************************* //
