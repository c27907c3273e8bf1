// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellTransfer.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cellTransfer::findRuns
(
    const cartesianMap& map,
    const blockLayout& layout
)
{
    DynamicList<run> runs;
    places_.setSize(map.cells().size());
    forAll(map.cells(), celli)
    {
        const label place = layout.globalIndex(map.cells()[celli]);
        places_[celli] = place;
        if
        (
            runs.size()
         && runs.last().place + runs.last().length == place
        )
        {
            ++runs.last().length;
        }
        else
        {
            runs.append(run{celli, place, 1});
        }
    }
    runs_.transfer(runs);
}


void Foam::fsi::cellTransfer::sendToBoxes() const
{
    UPstream::allToAll
    (
        reinterpret_cast<const char*>(sendBuffer_.cdata()),
        sendSize_, sendOffset_,
        reinterpret_cast<char*>(receiveBuffer_.data()),
        receiveSize_, receiveOffset_, comm_
    );
}


void Foam::fsi::cellTransfer::planMessages
(
    const cartesianMap& map,
    const blockPartition& partition
)
{
    const label nRanks = UPstream::nProcs(comm_);
    labelList count(nRanks, label(0));
    labelList owner(map.cells().size());
    forAll(owner, celli)
    {
        owner[celli] = partition.owner(map.cells()[celli]);
        ++count[owner[celli]];
    }
    labelList received(nRanks);
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

    // The place, as a number a double holds exactly, travels like a value
    List<blockLayout> layouts(nRanks);
    forAll(layouts, ranki)
    {
        if (count[ranki])
        {
            layouts[ranki] = partition.layout(ranki);
        }
    }
    forAll(owner, celli)
    {
        const label i = next[owner[celli]]++;
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cellTransfer::cellTransfer
(
    const cartesianMap& map,
    const blockPartition& partition
)
:
    comm_(map.mesh().comm()),
    local_(true)
{
    const label me = UPstream::parRun() ? UPstream::myProcNo(comm_) : 0;
    for (const labelVector& cell : map.cells())
    {
        local_ = local_ && partition.owner(cell) == me;
    }
    reduce(local_, andOp<bool>(), UPstream::msgType(), comm_);

    if (local_)
    {
        findRuns(map, partition.layout(me));
    }
    else
    {
        planMessages(map, partition);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::fsi::cellTransfer::toBlock
(
    const UList<scalar>& cells,
    const scalar factor,
    Type* block
) const
{
    if (local_)
    {
        for (const run& r : runs_)
        {
            const scalar* from = cells.cdata() + r.cell;
            Type* to = block + r.place;
            for (label i = 0; i < r.length; ++i)
            {
                to[i] = Type(factor*from[i]);
            }
        }
        return;
    }

    forAll(sendCell_, i)
    {
        sendBuffer_[i] = cells[sendCell_[i]];
    }
    sendToBoxes();
    forAll(receivePlace_, i)
    {
        block[receivePlace_[i]] = Type(factor*receiveBuffer_[i]);
    }
}


template<class Type>
void Foam::fsi::cellTransfer::toCells
(
    const Type* block,
    const scalar factor,
    UList<scalar>& cells
) const
{
    if (local_)
    {
        for (const run& r : runs_)
        {
            const Type* from = block + r.place;
            scalar* to = cells.data() + r.cell;
            for (label i = 0; i < r.length; ++i)
            {
                to[i] = factor*scalar(from[i]);
            }
        }
        return;
    }

    forAll(receivePlace_, i)
    {
        receiveBuffer_[i] = block[receivePlace_[i]];
    }
    UPstream::allToAll
    (
        reinterpret_cast<const char*>(receiveBuffer_.cdata()),
        receiveSize_, receiveOffset_,
        reinterpret_cast<char*>(sendBuffer_.data()),
        sendSize_, sendOffset_, comm_
    );
    forAll(sendCell_, i)
    {
        cells[sendCell_[i]] = factor*sendBuffer_[i];
    }
}


// * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * * //

#define instantiateTransfer(Type)                                              \
    template void Foam::fsi::cellTransfer::toBlock                             \
    (                                                                          \
        const UList<scalar>&, const scalar, Type*                              \
    ) const;                                                                   \
    template void Foam::fsi::cellTransfer::toCells                             \
    (                                                                          \
        const Type*, const scalar, UList<scalar>&                              \
    ) const;

instantiateTransfer(float)
instantiateTransfer(double)

#undef instantiateTransfer


// ************************************************************************* //
