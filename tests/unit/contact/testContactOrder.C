// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactOrder.H"
#include "openfoamVersion.H"
#include "randomNumbers.H"
#include "rigidBodies.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const label nSide = 5;


//- Places in a grid in another order for each seed; as they are for 0
labelList shuffled(const label n, const label seed)
{
    labelList places(n);
    forAll(places, i)
    {
        places[i] = i;
    }
    randomNumbers random(seed);
    for (label i = n - 1; i > 0 && seed > 0; --i)
    {
        Swap(places[i], places[label(i*random.sample01<scalar>())]);
    }
    return places;
}


//- Discs that rush towards the middle, stored in the order of their places
struct packedDiscs
:
    rigidBodies
{
    explicit packedDiscs(const labelList& places)
    {
        feelLaw = true;
        ids = places;
        for (const label place : places)
        {
            const point centre(2.05*(place % nSide), 2.05*(place/nSide), 0);
            const point middle(0.9*nSide, 1.1*nSide, 0);
            add(circleNodes(1, 24), centre, middle - centre, 0.1*place);
        }
        walls.append(contactWall(vector(-1.02, 0, 0), vector(1, 0, 0)));
    }
};


//- Pairs of a disc's node with a disc, in all ways that a grid has
DynamicList<contactPair> pairsOf(const surfaceSet& surfaces)
{
    DynamicList<contactPair> pairs;
    for (label a = 0; a < surfaces.size(); ++a)
    {
        for (const label step : {1, nSide, nSide + 1})
        {
            const label b = a + step;
            contactPair pair;
            pair.node = surfaces.pointStart()[a] + step;
            pair.face = b < surfaces.size() ? surfaces.faceStart()[b] : -1;
            pair.other = b < surfaces.size() ? b : -1;
            pairs.append(pair);
        }
    }
    return pairs;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(ContactOrder, edgesOfAColourShareNoObject)
{
    packedDiscs discs(shuffled(nSide*nSide, 0));
    discs.update();
    const DynamicList<contactPair> pairs(pairsOf(discs.surfaces));
    contactOrder order;
    order.set(discs.surfaces, discs.bodies, pairs);

    // A disc has at most six neighbours and a wall
    EXPECT_GE(order.nColours(), 6);
    EXPECT_LE(order.nColours(), 11);

    labelList visited(pairs.size(), Zero);
    labelList edgeOf(discs.surfaces.size(), -1);
    forAll(order.pairs(), i)
    {
        const label pairi = order.pairs()[i];
        const contactPair& pair = pairs[pairi];
        ++visited[pairi];
        if (isIn(order.starts(), i))
        {
            edgeOf = -1;
        }
        const label own = discs.surfaces.pointObject()[pair.node];
        const label edge = own*discs.surfaces.size() + max(pair.other, own);
        for (const label objecti : {own, max(pair.other, own)})
        {
            EXPECT_TRUE(edgeOf[objecti] < 0 || edgeOf[objecti] == edge);
            edgeOf[objecti] = edge;
        }
    }
    EXPECT_EQ(min(visited), 1);
    EXPECT_EQ(max(visited), 1);
}


TEST(ContactOrder, resultsDoNotDependOnHowBodiesAreStored)
{
    const labelList asTheyAre(shuffled(nSide*nSide, 0));
    packedDiscs discs(asTheyAre);
    contact law(dictionary(), 2, 0.2, 1);
    discs.advance(law, 0.02);
    EXPECT_GT(discs.statistics.contacts, nSide*nSide);
    EXPECT_GT(discs.statistics.sweeps, 3);
    for (const label seed : {1, 2})
    {
        const labelList places(shuffled(nSide*nSide, seed));
        packedDiscs others(places);
        contact same(dictionary(), 2, 0.2, 1);
        others.advance(same, 0.02);
        EXPECT_EQ(others.statistics.sweeps, discs.statistics.sweeps);
        forAll(places, i)
        {
            const vector& v = discs.solids[places[i]].velocity;
            EXPECT_EQ(others.solids[i].velocity, v) << i;
        }
    }
}


// ************************************************************************* //
