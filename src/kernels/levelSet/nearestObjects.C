// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearestObjects.H"
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::nearestObjects::nearestObjects(const cartesianBlock& block)
:
    block_(block),
    entries_(block.size())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::nearestObjects::earlier
(
    std::vector<label>& offsets,
    std::vector<float>& lengths
) const
{
    const label depth = block_.nDims() == 3 ? 1 : 0;
    for (label k = -depth; k <= 0; ++k)
    {
        for (label j = -1; j <= 1; ++j)
        {
            for (label i = -1; i <= 1; ++i)
            {
                const label offset =
                    i + j*block_.stride(1) + k*block_.stride(2);
                if (offset < 0)
                {
                    offsets.push_back(offset);
                    lengths.push_back(std::sqrt(float(i*i + j*j + k*k)));
                }
            }
        }
    }
}


void Foam::fsi::nearestObjects::sweepRow
(
    const label j,
    const label k,
    const label sign,
    const std::vector<label>& offsets,
    const std::vector<float>& lengths
)
{
    const label nx = block_.n().x();
    const label row = block_.index(0, j, k);
    for (label step = 1; step < nx - 1; ++step)
    {
        const label samplei = row + (sign > 0 ? step : nx - 1 - step);
        entry& here = entries_[samplei];
        for (std::size_t o = 0; o < offsets.size(); ++o)
        {
            const entry& there = entries_[samplei + sign*offsets[o]];
            for (label rank = 0; rank < nNearest; ++rank)
            {
                const float d = there.distance[rank] + lengths[o];
                if (d >= here.distance[nNearest - 1])
                {
                    break;
                }
                here.take(there.object[rank], d);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::nearestObjects::march()
{
    std::vector<label> offsets;
    std::vector<float> lengths;
    earlier(offsets, lengths);

    const labelVector& n = block_.n();
    const bool threeD = block_.nDims() == 3;
    const label nRows = (n.y() - 2)*(threeD ? n.z() - 2 : 1);
    for (const label sign : {1, -1})
    {
        for (label step = 0; step < nRows; ++step)
        {
            const label r = sign > 0 ? step : nRows - 1 - step;
            sweepRow
            (
                1 + r % (n.y() - 2),
                threeD ? 1 + r/(n.y() - 2) : 0,
                sign,
                offsets,
                lengths
            );
        }
    }
}


// ************************************************************************* //
