// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxRemap.H"
#include "exchangeBytes.H"
#include "Pstream.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::blockLayout Foam::fsi::boxRemap::common
(
    const blockLayout& a,
    const blockLayout& b
)
{
    labelVector n, start;
    for (direction d = 0; d < 3; ++d)
    {
        start[d] = max(a.start()[d], b.start()[d]);
        n[d] = min(a.start()[d] + a.n()[d], b.start()[d] + b.n()[d]) - start[d];
        n[d] = max(n[d], label(0));
    }
    return blockLayout
    (
        n, start, labelVector(0, 0, 0), FixedList<label, 6>(label(-1))
    );
}


Foam::fsi::boxRemap::side Foam::fsi::boxRemap::parts
(
    const blockPartition& own,
    const blockPartition& other,
    const label comm
)
{
    const label nRanks = UPstream::nProcs(comm);
    side result;
    result.box = own.layout(UPstream::myProcNo(comm));
    result.parts.setSize(nRanks);
    result.size.setSize(nRanks);
    result.offset.setSize(nRanks);
    label nValues = 0;
    for (label ranki = 0; ranki < nRanks; ++ranki)
    {
        result.parts[ranki] = common(result.box, other.layout(ranki));
        result.size[ranki] = result.parts[ranki].nCells()*sizeof(scalar);
        result.offset[ranki] = nValues*sizeof(scalar);
        nValues += result.parts[ranki].nCells();
    }
    result.buffer.setSize(nValues);
    return result;
}


template<class Visitor>
void Foam::fsi::boxRemap::forRows(const side& s, const Visitor& visit)
{
    for (const blockLayout& part : s.parts)
    {
        labelVector cell(part.start());
        for (label k = 0; k < part.n().z(); ++k)
        {
            for (label j = 0; j < part.n().y(); ++j)
            {
                cell.y() = part.start().y() + j;
                cell.z() = part.start().z() + k;
                visit(s.box.globalIndex(cell), part.n().x());
            }
        }
    }
}


void Foam::fsi::boxRemap::move
(
    const side& sender,
    const double* values,
    const side& receiver,
    double* result
) const
{
    double* next = sender.buffer.data();
    forRows
    (
        sender,
        [&](const label place, const label length)
        {
            next = std::copy(values + place, values + place + length, next);
        }
    );
    exchangeBytes
    (
        reinterpret_cast<const char*>(sender.buffer.cdata()),
        sender.size, sender.offset,
        reinterpret_cast<char*>(receiver.buffer.data()),
        receiver.size, receiver.offset, comm_
    );
    const double* from = receiver.buffer.cdata();
    forRows
    (
        receiver,
        [&](const label place, const label length)
        {
            std::copy(from, from + length, result + place);
            from += length;
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::boxRemap::boxRemap
(
    const blockPartition& from,
    const blockPartition& to,
    const label comm
)
:
    comm_(comm),
    from_(parts(from, to, comm)),
    to_(parts(to, from, comm))
{}


// ************************************************************************* //
