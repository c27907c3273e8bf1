// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellTransfer.H"
#include "exchangeBytes.H"
#include "latticeRanks.H"
#include "Pstream.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cellTransfer::findRuns
(
    const cartesianMap& map,
    const blockLayout& layout
)
{
    DynamicList<run> runs;
    forAll(map.cells(), celli)
    {
        if (places_[celli] < 0)
        {
            continue;
        }
        const label place = layout.globalIndex(map.cells()[celli]);
        places_[celli] = place;
        if
        (
            runs.size()
         && runs.last().place + runs.last().length == place
         && runs.last().cell + runs.last().length == celli
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
    exchangeBytes
    (
        reinterpret_cast<const char*>(sendBuffer_.cdata()),
        sendSize_, sendOffset_,
        reinterpret_cast<char*>(receiveBuffer_.data()),
        receiveSize_, receiveOffset_, comm_
    );
}


void Foam::fsi::cellTransfer::sendToCells() const
{
    exchangeBytes
    (
        reinterpret_cast<const char*>(receiveBuffer_.cdata()),
        receiveSize_, receiveOffset_,
        reinterpret_cast<char*>(sendBuffer_.data()),
        sendSize_, sendOffset_, comm_
    );
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
    const label me = rankIn(comm_);
    for (const labelVector& cell : map.cells())
    {
        local_ = local_ && partition.owner(cell) == me;
    }
    reduceOverRanks(local_, andOp<bool>(), comm_);

    places_.setSize(map.cells().size(), 0);
    if (!local_)
    {
        planMessages(map, partition);
    }
    findRuns(map, partition.layout(me));
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
    for (const run& r : runs_)
    {
        const scalar* from = cells.cdata() + r.cell;
        Type* to = block + r.place;
        for (label i = 0; i < r.length; ++i)
        {
            to[i] = Type(factor*from[i]);
        }
    }
    if (local_)
    {
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
    for (const run& r : runs_)
    {
        const Type* from = block + r.place;
        scalar* to = cells.data() + r.cell;
        for (label i = 0; i < r.length; ++i)
        {
            to[i] = factor*scalar(from[i]);
        }
    }
    if (local_)
    {
        return;
    }

    forAll(receivePlace_, i)
    {
        receiveBuffer_[i] = block[receivePlace_[i]];
    }
    sendToCells();
    forAll(sendCell_, i)
    {
        cells[sendCell_[i]] = factor*sendBuffer_[i];
    }
}


void Foam::fsi::cellTransfer::gather
(
    const labelUList& places,
    const scalarField& block,
    scalarField& values
) const
{
    if (!local_)
    {
        forAll(receivePlace_, i)
        {
            receiveBuffer_[i] = block[receivePlace_[i]];
        }
        sendToCells();
    }
    values.setSize(places.size());
    forAll(places, i)
    {
        const label place = places[i];
        values[i] = place < 0 ? sendBuffer_[-1 - place] : block[place];
    }
}


void Foam::fsi::cellTransfer::add
(
    const labelUList& places,
    const scalarField& values,
    scalarField& block
) const
{
    sendBuffer_ = 0;
    forAll(places, i)
    {
        const label place = places[i];
        (place < 0 ? sendBuffer_[-1 - place] : block[place]) += values[i];
    }
    if (!local_)
    {
        sendToBoxes();
        forAll(receivePlace_, i)
        {
            block[receivePlace_[i]] += receiveBuffer_[i];
        }
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
