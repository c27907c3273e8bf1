// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectRanks.H"
#include "sumOverRanks.H"
#include "swapLists.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::scalarList> Foam::fsi::objectRanks::swap
(
    const UList<DynamicList<scalar>>& sent
) const
{
    return swapLists(sent, partner_);
}


void Foam::fsi::objectRanks::collect
(
    List<DynamicList<scalar>>& ofObjects
) const
{
    if (shared_ && !severalRanks())
    {
        return;
    }

    // Per object its place, the number of its values, and these
    const auto append = [&](const label i, const label objecti, auto& packed)
    {
        const DynamicList<scalar>& mine = ofObjects[objecti];
        packed.append(i);
        packed.append(mine.size());
        packed.append(mine);
    };
    const auto take = [&](const labelUList& objects, const scalarList& packed)
    {
        for (label i = 0; i < packed.size();)
        {
            const label objecti = objects[label(packed[i])];
            const label n = packed[i + 1];
            ofObjects[objecti].append(SubList<scalar>(packed, n, i + 2));
            i += n + 2;
        }
    };

    if (!shared_)
    {
        List<DynamicList<scalar>> sent(nRanks());
        forAll(sent, ranki)
        {
            forAll(guests_[ranki], i)
            {
                append(i, guests_[ranki][i], sent[ranki]);
            }
        }
        const List<scalarList> received(swap(sent));
        forAll(received, ranki)
        {
            take(lent_[ranki], received[ranki]);
        }
        return;
    }
    DynamicList<scalar> packed;
    labelList all(ofObjects.size());
    forAll(all, objecti)
    {
        all[objecti] = objecti;
        append(objecti, objecti, packed);
        ofObjects[objecti].clear();
    }
    for (const scalarList& ofRank : gatherOverRanks(scalarList(packed)))
    {
        take(all, ofRank);
    }
}


Foam::scalarList Foam::fsi::objectRanks::gathered
(
    const scalarList& mine,
    const bool onAll
) const
{
    if (shared_)
    {
        return mine;
    }
    labelList received(gatherOverRanks(mine.size()));
    labelList sent(received.size(), Zero);
    DynamicList<scalar> copies;
    for (label ranki = 0; ranki < (onAll ? nRanks() : 1); ++ranki)
    {
        sent[ranki] = mine.size();
        copies.append(mine);
    }
    if (!onAll && rankIn() > 0)
    {
        received = Zero;
    }
    return exchangeLists(copies, sent, received);
}


// ************************************************************************* //
