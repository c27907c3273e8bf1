// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectRanks.H"
#include "swapLists.H"
#include "sumOverRanks.H"

#include <map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Action>
void Foam::fsi::objectRanks::forRanges
(
    const labelUList& objects,
    const valueLists& all,
    const Action& action
) const
{
    for (const values& each : all)
    {
        for (const label objecti : objects)
        {
            if (each.walls && !hasWalls_[objecti])
            {
                continue;
            }
            const label first = each.nodes ? pointStart_[objecti] : objecti;
            const label end =
                each.nodes ? pointStart_[objecti + 1] : first + 1;
            action(each.data + each.width*first, each.width*(end - first));
        }
    }
}


template<class Operation>
void Foam::fsi::objectRanks::send
(
    const labelListList& from,
    const labelListList& to,
    const valueLists& all,
    const Operation& operation
) const
{
    labelList sentSizes(from.size(), Zero), receivedSizes(to.size(), Zero);
    DynamicList<scalar> sent;
    forAll(from, ranki)
    {
        forRanges(from[ranki], all, [&](scalar* first, const label n)
        {
            sent.append(UList<scalar>(first, n));
            sentSizes[ranki] += n;
        });
        forRanges(to[ranki], all, [&](const scalar*, const label n)
        {
            receivedSizes[ranki] += n;
        });
    }
    const scalarList received(exchangeLists(sent, sentSizes, receivedSizes));
    const scalar* next = received.cdata();
    for (const labelList& objects : to)
    {
        forRanges(objects, all, [&](scalar* first, const label n)
        {
            for (label i = 0; i < n; ++i)
            {
                operation(first[i], *next++);
            }
        });
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectRanks::objectRanks()
:
    shared_(true),
    nOwned_(0)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::fsi::objectRanks& Foam::fsi::objectRanks::everywhere()
{
    static const objectRanks all;
    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectRanks::share(const reachBoxes& reach)
{
    shared_ = false;
    reach_ = reach;
    lent_.setSize(nRanksIn());
    guests_.setSize(nRanksIn());
    partner_.setSize(nRanksIn(), false);
}


void Foam::fsi::objectRanks::setNodes(const surfaceSet& surfaces)
{
    pointStart_ = surfaces.pointStart();
    hasWalls_.setSize(surfaces.size());
    forAll(hasWalls_, objecti)
    {
        hasWalls_[objecti] = surfaces.hasWalls(objecti);
    }
}


Foam::List<Foam::labelPair> Foam::fsi::objectRanks::findHolders
(
    const UList<boundBox>& boxes,
    const UList<labelPair>& keys
)
{
    nOwned_ = boxes.size();
    reach_.find(boxes, partner_, lent_);
    List<DynamicList<scalar>> sent(nRanks());
    forAll(lent_, ranki)
    {
        for (const label objecti : lent_[ranki])
        {
            sent[ranki].append(keys[objecti].first());
            sent[ranki].append(keys[objecti].second());
        }
    }

    // Guests in the order of their keys
    const List<scalarList> received(swap(sent));
    std::map<labelPair, label> places;
    const auto forKeys = [&](const auto& action)
    {
        forAll(received, ranki)
        {
            for (label i = 0; i < received[ranki].size(); i += 2)
            {
                const scalar* key = received[ranki].cdata() + i;
                action(ranki, i/2, labelPair(label(key[0]), label(key[1])));
            }
        }
    };
    forKeys([&](const label, const label, const labelPair& key)
    {
        places[key] = 0;
    });
    DynamicList<labelPair> sorted;
    for (auto& place : places)
    {
        place.second = nOwned_ + sorted.size();
        sorted.append(place.first);
    }
    owners_.setSize(sorted.size());
    forAll(received, ranki)
    {
        guests_[ranki].setSize(received[ranki].size()/2);
    }
    forKeys([&](const label ranki, const label i, const labelPair& key)
    {
        guests_[ranki][i] = places[key];
        owners_[places[key] - nOwned_] = ranki;
    });
    return List<labelPair>(std::move(sorted));
}



void Foam::fsi::objectRanks::spread
(
    const valueLists& all,
    const callPlace& place
) const
{
    if (!shared_)
    {
        collectiveCalls::check(place, -1, UPstream::worldComm);
        send(lent_, guests_, all, [](scalar& value, const scalar sent)
        {
            value = sent;
        });
    }
}


void Foam::fsi::objectRanks::collect
(
    const valueLists& all,
    const callPlace& place
) const
{
    if (!shared_)
    {
        collectiveCalls::check(place, -1, UPstream::worldComm);
        send(guests_, lent_, all, [](scalar& value, const scalar sent)
        {
            value += sent;
        });
        return;
    }
    if (!severalRanks())
    {
        return;
    }
    DynamicList<scalar> packed;
    for (const values& each : all)
    {
        packed.append(UList<scalar>(each.data, each.width*each.size));
    }
    sumOverRanks(packed, place);
    const scalar* next = packed.cdata();
    for (const values& each : all)
    {
        const label n = each.width*each.size;
        std::copy(next, next + n, each.data);
        next += n;
    }
}


void Foam::fsi::objectRanks::collectLeast(scalarField& ofObjects) const
{
    if (!shared_)
    {
        send
        (
            guests_,
            lent_,
            {values::ofObjects(ofObjects)},
            [](scalar& value, const scalar sent) { value = min(value, sent); }
        );
    }
}


Foam::scalar Foam::fsi::objectRanks::sum(const scalar value) const
{
    return shared_ ? value : overRanks(value, sumOp<scalar>());
}


Foam::scalar Foam::fsi::objectRanks::largest(const scalar value) const
{
    return shared_ ? value : overRanks(value, maxOp<scalar>());
}


void Foam::fsi::objectRanks::sum(scalarField& values) const
{
    if (!shared_)
    {
        sumOverRanks(values);
    }
}


// ************************************************************************* //
