// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactRanges.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactRanges::update
(
    const surfaceSet& surfaces,
    UList<contactPair>& pairs
)
{
    if (ranges_.size() != surfaces.size())
    {
        return;
    }

    scalarField nearest(surfaces.size(), full_);
    for (const contactPair& pair : pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        if (pair.other != own)
        {
            nearest[own] = min(nearest[own], pair.gap);
            if (pair.other >= 0)
            {
                nearest[pair.other] = min(nearest[pair.other], pair.gap);
            }
        }
    }
    forAll(ranges_, objecti)
    {
        ranges_[objecti] = max(ranges_[objecti], max(nearest[objecti], least_));
    }

    for (contactPair& pair : pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        if (pair.other != own)
        {
            const scalar range =
                pair.other < 0
              ? ranges_[own]
              : min(ranges_[own], ranges_[pair.other]);
            pair.stretch = full_/range;
        }
    }
}


Foam::fsi::contactPairs Foam::fsi::contactRanges::acting
(
    const surfaceSet& surfaces,
    const contactPairs& found,
    const scalar margin
) const
{
    contactPairs result;
    result.nodePairs = found.nodePairs;
    for (const contactPair& pair : found.pairs)
    {
        if
        (
            pair.stretch == 1
         || pair.other == surfaces.pointObject()[pair.node]
         || pair.gap <= full_/pair.stretch + margin
        )
        {
            result.pairs.append(pair);
        }
    }
    return result;
}


// ************************************************************************* //
