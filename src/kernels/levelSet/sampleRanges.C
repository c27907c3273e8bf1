// SPDX-License-Identifier: GPL-3.0-or-later

#include "sampleRanges.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Boxes that hold this part of a block are not told apart
static const scalar goodPart = 0.25;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::sampleRanges::clear()
{
    ranges_.clear();
    nSamples_ = 0;
}


void Foam::fsi::sampleRanges::add
(
    const cartesianBlock& block,
    const point& lower,
    const point& upper
)
{
    labelVector first(0, 0, 0), end(1, 1, 1);
    for (direction dir = 0; dir < block.nDims(); ++dir)
    {
        first[dir] = block.nUpTo(lower[dir], dir);
        end[dir] = block.nUpTo(upper[dir], dir);
    }
    const labelVector n(end - first);
    if (cmptMin(n) <= 0 || nSamples_ > goodPart*block.size())
    {
        return;
    }

    nSamples_ += n.x()*n.y()*n.z();
    for (label k = first.z(); k < end.z(); ++k)
    {
        for (label j = first.y(); j < end.y(); ++j)
        {
            const label begin = block.index(first.x(), j, k);
            ranges_.append(labelPair(begin, begin + n.x()));
        }
    }
}


void Foam::fsi::sampleRanges::merge(const cartesianBlock& block)
{
    if (nSamples_ > goodPart*block.size())
    {
        *this = sampleRanges(block);
        return;
    }

    std::sort(ranges_.begin(), ranges_.end());
    label n = 0;
    for (const labelPair& r : ranges_)
    {
        if (n && r.first() <= ranges_[n - 1].second())
        {
            labelPair& last = ranges_[n - 1];
            last.second() = max(last.second(), r.second());
        }
        else
        {
            ranges_[n++] = r;
        }
    }
    ranges_.resize(n);

    nSamples_ = 0;
    for (const labelPair& r : ranges_)
    {
        nSamples_ += r.second() - r.first();
    }
}


// ************************************************************************* //
