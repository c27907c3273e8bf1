// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellTransfer.H"
#include "collectiveCalls.H"
#include "Pstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cellTransfer::planMessages
(
    const cartesianMap& map,
    const blockPartition& partition
)
{
    const label nRanks = UPstream::nProcs(comm_);
    const label me = UPstream::myProcNo(comm_);
    labelList count(nRanks, label(0));
    labelList owner(map.cells().size());
    forAll(owner, celli)
    {
        owner[celli] = partition.owner(map.cells()[celli]);
        count[owner[celli]] += owner[celli] != me;
    }
    labelList received(nRanks);
    collectiveCalls::check(callPlace(), nRanks, comm_);
    UPstream::allToAll(count, received, comm_);

    sendSize_.setSize(nRanks);
    sendOffset_.setSize(nRanks);
    receiveSize_.setSize(nRanks);
    receiveOffset_.setSize(nRanks);
    labelList next(nRanks);
    label nSent = 0;
    label nReceived = 0;
    for (label ranki = 0; ranki < nRanks; ++ranki)
    {
        next[ranki] = nSent;
        sendSize_[ranki] = count[ranki]*sizeof(scalar);
        sendOffset_[ranki] = nSent*sizeof(scalar);
        receiveSize_[ranki] = received[ranki]*sizeof(scalar);
        receiveOffset_[ranki] = nReceived*sizeof(scalar);
        nSent += count[ranki];
        nReceived += received[ranki];
    }

    sendCell_.setSize(nSent);
    receivePlace_.setSize(nReceived);
    sendBuffer_.setSize(nSent);
    receiveBuffer_.setSize(nReceived);

    exchangePlaces(map, partition, owner, next);
}


void Foam::fsi::cellTransfer::exchangePlaces
(
    const cartesianMap& map,
    const blockPartition& partition,
    const labelList& owner,
    labelList& next
)
{
    const label me = UPstream::myProcNo(comm_);
    // The place, as a number a double holds exactly, travels like a value
    List<blockLayout> layouts(next.size());
    forAll(layouts, ranki)
    {
        if (sendSize_[ranki])
        {
            layouts[ranki] = partition.layout(ranki);
        }
    }
    forAll(owner, celli)
    {
        if (owner[celli] == me)
        {
            continue;
        }
        const label i = next[owner[celli]]++;
        places_[celli] = -1 - i;
        sendCell_[i] = celli;
        sendBuffer_[i] =
            layouts[owner[celli]].globalIndex(map.cells()[celli]);
    }
    sendToBoxes();
    forAll(receivePlace_, i)
    {
        receivePlace_[i] = label(receiveBuffer_[i]);
    }
}


// ************************************************************************* //
