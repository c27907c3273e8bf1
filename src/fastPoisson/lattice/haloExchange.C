// SPDX-License-Identifier: GPL-3.0-or-later

#include "haloExchange.H"
#include "latticeRanks.H"
#include "UIPstream.H"
#include "UOPstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Visitor>
void Foam::fsi::haloExchange::visitLayer
(
    const direction d,
    const label layer,
    const Visitor& visit
) const
{
    labelVector low(0, 0, 0);
    labelVector high(layout_.n());
    low[d] = layer;
    high[d] = layer + 1;
    for (label k = low.z(); k < high.z(); ++k)
    {
        for (label j = low.y(); j < high.y(); ++j)
        {
            const label row = layout_.index(0, j, k);
            for (label i = low.x(); i < high.x(); ++i)
            {
                visit(row + i);
            }
        }
    }
}


template<class Type>
void Foam::fsi::haloExchange::pack
(
    const direction d,
    const label side,
    const Type* x
) const
{
    List<char>& buffer = send_[2*d + side];
    buffer.setSize(layout_.nCells()/layout_.n()[d]*sizeof(Type));
    Type* next = reinterpret_cast<Type*>(buffer.data());
    visitLayer
    (
        d,
        layer(d, side, false),
        [&](const label place) { *next++ = x[place]; }
    );
}


template<class Type>
void Foam::fsi::haloExchange::unpack
(
    const direction d,
    const label side,
    Type* x
) const
{
    // A box sends from its low side to the high side of the next one
    const bool self = layout_.neighbour(d, side) == rank_;
    const List<char>& buffer =
        self ? send_[2*d + 1 - side] : receive_[2*d + side];
    const Type* next = reinterpret_cast<const Type*>(buffer.cdata());
    visitLayer
    (
        d,
        layer(d, side, true),
        [&](const label place) { x[place] = *next++; }
    );
}


void Foam::fsi::haloExchange::start
(
    const direction d,
    const label side
) const
{
    const label to = layout_.neighbour(d, side);
    const label from = layout_.neighbour(d, 1 - side);
    const label tag = UPstream::msgType() + 2*d + side;
    const List<char>& sent = send_[2*d + side];
    List<char>& received = receive_[2*d + 1 - side];

    if (from >= 0 && from != rank_)
    {
        received.setSize(send_[2*d + 1 - side].size());
        UIPstream::read
        (
            UPstream::commsTypes::nonBlocking,
            from, received.data(), received.size(), tag, comm_
        );
    }
    if (to >= 0 && to != rank_)
    {
        UOPstream::write
        (
            UPstream::commsTypes::nonBlocking,
            to, sent.cdata(), sent.size(), tag, comm_
        );
    }
}


template<class Type>
void Foam::fsi::haloExchange::fill
(
    const FixedList<bool, 6>& use,
    Type* x
) const
{
    const label first = UPstream::nRequests();
    for (direction d = 0; d < 3; ++d)
    {
        for (label side = 0; side < 2; ++side)
        {
            if (use[2*d] || use[2*d + 1])
            {
                pack(d, side, x);
            }
        }
        // Only what fills a halo that is used is sent
        for (label side = 0; side < 2; ++side)
        {
            if (use[2*d + 1 - side])
            {
                start(d, side);
            }
        }
    }
    UPstream::waitRequests(first);

    for (direction d = 0; d < 3; ++d)
    {
        for (label side = 0; side < 2; ++side)
        {
            if (use[2*d + side] && layout_.neighbour(d, side) >= 0)
            {
                unpack(d, side, x);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::haloExchange::haloExchange
(
    const blockLayout& layout,
    const label comm
)
:
    layout_(layout),
    comm_(comm),
    rank_(rankIn(comm))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::fsi::haloExchange::fill(Type* x) const
{
    if (layout_.coupled())
    {
        FixedList<bool, 6> use;
        for (direction d = 0; d < 3; ++d)
        {
            use[2*d] = use[2*d + 1] =
                layout_.neighbour(d, 0) >= 0 || layout_.neighbour(d, 1) >= 0;
        }
        fill(use, x);
    }
}


template<class Type>
void Foam::fsi::haloExchange::fillHigh(const direction d, Type* x) const
{
    if (layout_.nCells())
    {
        FixedList<bool, 6> use(false);
        use[2*d + 1] = true;
        fill(use, x);
    }
}


// * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * * //

template void Foam::fsi::haloExchange::fill(float*) const;
template void Foam::fsi::haloExchange::fill(double*) const;
template void Foam::fsi::haloExchange::fillHigh(const direction, float*) const;
template void Foam::fsi::haloExchange::fillHigh(const direction, double*) const;


// ************************************************************************* //
