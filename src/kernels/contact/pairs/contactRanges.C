// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactRanges.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::contactRanges::full() const
{
    for (const scalar range : ranges_)
    {
        if (range != full_)
        {
            return false;
        }
    }
    return true;
}


Foam::scalarField Foam::fsi::contactRanges::nearestGaps
(
    const surfaceSet& surfaces,
    const UList<contactPair>& pairs
) const
{
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
    return nearest;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::contactRanges::reaches
(
    const surfaceSet& surfaces,
    const scalar margin
) const
{
    if (ranges_.size() != surfaces.size() || full())
    {
        return scalarField();
    }
    scalarField reaches(surfaces.size());
    forAll(reaches, objecti)
    {
        const scalar range = ranges_[objecti];
        reaches[objecti] =
            margin + (range > 0 ? min(range + growth*margin, full_) : full_);
    }
    return reaches;
}


bool Foam::fsi::contactRanges::widen
(
    const surfaceSet& surfaces,
    const UList<contactPair>& pairs,
    const scalar margin,
    scalarField& reaches
) const
{
    if (reaches.empty())
    {
        return false;
    }
    const scalarField nearest(nearestGaps(surfaces, pairs));
    bool wider = false;
    forAll(reaches, objecti)
    {
        const scalar looked = reaches[objecti] - margin;
        if (looked < (1 - SMALL)*full_ && nearest[objecti] > looked)
        {
            reaches[objecti] = full_ + margin;
            wider = true;
        }
    }
    return wider;
}


void Foam::fsi::contactRanges::update
(
    const surfaceSet& surfaces,
    UList<contactPair>& pairs,
    const contactExchange* exchange
)
{
    if (ranges_.size() != surfaces.size() || (full() && !exchange))
    {
        return;
    }

    const scalarField nearest(nearestGaps(surfaces, pairs));
    forAll(ranges_, objecti)
    {
        ranges_[objecti] = max(ranges_[objecti], max(nearest[objecti], least_));
    }
    if (exchange)
    {
        exchange->spread(ranges_);
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


const Foam::fsi::contactPairs& Foam::fsi::contactRanges::acting
(
    const surfaceSet& surfaces,
    const contactPairs& found,
    const scalar margin
)
{
    if (full())
    {
        return found;
    }
    acting_.clear();
    acting_.nodePairs = found.nodePairs;
    for (const contactPair& pair : found.pairs)
    {
        if
        (
            pair.stretch == 1
         || pair.other == surfaces.pointObject()[pair.node]
         || pair.gap <= full_/pair.stretch + margin
        )
        {
            acting_.pairs.append(pair);
        }
    }
    return acting_;
}


// ************************************************************************* //
