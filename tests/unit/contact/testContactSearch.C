// SPDX-License-Identifier: GPL-3.0-or-later

#include "searchCases.H"
#include "randomNumbers.H"

TEST(ContactSearch, findsWhatBruteForceFinds)
{
    const surfaceSet surfaces(lattice(5, 20, 2.2));
    for (const scalar range : {0.25, 0.5, 1.3})
    {
        const contactPairs found(contactsOf(surfaces, range));
        EXPECT_GT(found.pairs.size(), 0);
        expectSame(found, bruteForce(surfaces, range));
    }
}


TEST(ContactSearch, findsWhatBruteForceFindsInSpace)
{
    const surfaceSet surfaces(octahedra(12));
    ASSERT_NEAR(surfaces.volume(0), 4.0/3, 1e-12);
    const contactPairs found(contactsOf(surfaces, 0.7));
    EXPECT_GT(found.pairs.size(), 20);
    expectSame(found, bruteForce(surfaces, 0.7));
}


TEST(ContactSearch, findsAllPairsOfWavyAndFoldedOutlines)
{
    const surfaceSet surfaces(wavyOutlines(40, 63));
    for (const scalar range : {0.1, 0.4})
    {
        const contactPairs found(contactsOf(surfaces, range));
        label nOwn = 0;
        for (const contactPair& p : found.pairs)
        {
            nOwn += p.other == surfaces.pointObject()[p.node];
        }
        for (label i = 1; i < found.pairs.size(); ++i)
        {
            ASSERT_LE(found.pairs[i - 1].node, found.pairs[i].node);
        }
        EXPECT_GT(nOwn, 50);
        EXPECT_GT(found.pairs.size() - nOwn, 10);
        expectSame(found, bruteForce(surfaces, range, true));
    }
}


TEST(ContactSearch, gapIsNegativeInside)
{
    surfaceSet surfaces(2);
    surfaces.append(circleNodes(1, 40), polygonFaces(40));
    pointField x(circleNodes(0.2, 9));
    x += vector(0.9, 0, 0);
    surfaces.append(x, polygonFaces(9));

    const contactPairs found(contactsOf(surfaces, 0.3));
    label nInside = 0;
    for (const contactPair& p : found.pairs)
    {
        if (p.other == 0)
        {
            const scalar r = mag(surfaces.points()[p.node]);
            EXPECT_NEAR(p.gap, r - 1, 4e-3);
            EXPECT_GT(p.normal & surfaces.points()[p.node], 0);
            nInside += p.gap < 0;
        }
    }
    EXPECT_GT(nInside, 3);
}


TEST(ContactSearch, aFoldHasNoInsideInFrontOfIt)
{
    surfaceSet surfaces(foldedBar());
    pointField x(circleNodes(0.1, 9));
    x += vector(3.8, 0.5, 0);
    surfaces.append(x, polygonFaces(9));

    const contactPairs found(contactsOf(surfaces, 0.5));
    label nFound = 0;
    for (const contactPair& p : found.pairs)
    {
        if (surfaces.pointObject()[p.node] == 1)
        {
            const scalar gap = surfaces.points()[p.node].x() - 3.5;
            EXPECT_NEAR(p.gap, gap, 1e-12);
            EXPECT_NEAR(mag(p.normal - vector(1, 0, 0)), 0, 1e-12);
            ++nFound;
        }
    }
    EXPECT_EQ(nFound, 9);
}


TEST(ContactSearch, kinksOfAnObjectHaveGapsInFront)
{
    // Nodes thrown about the circle by a spacing: faces that face each other
    // at kinks where the mean normal of a node says the opposite
    const label n = 60;
    label nPairs = 0;
    for (label seed = 1; seed < 40; ++seed)
    {
        randomNumbers random(seed);
        pointField x(circleNodes(1, n));
        for (point& p : x)
        {
            p.x() += 0.3*(random.sample01<scalar>() - 0.5);
            p.y() += 0.3*(random.sample01<scalar>() - 0.5);
        }
        surfaceSet surfaces(2);
        surfaces.append(x, polygonFaces(n));
        const contactPairs found(contactsOf(surfaces, 0.3));
        for (const contactPair& p : found.pairs)
        {
            ++nPairs;
            EXPECT_GT(p.gap, 0) << "seed " << seed << " node " << p.node;
        }
    }
    EXPECT_GT(nPairs, 100);
}


TEST(ContactSearch, walls)
{
    surfaceSet surfaces(2);
    surfaces.append(circleNodes(1, 64), polygonFaces(64));
    const List<contactWall> walls({contactWall({0, -1.1, 0}, {0, 3, 0})});

    contactPairs found;
    searchOf("")->find(surfaces, walls, noAxis, 0.2, found);
    ASSERT_GT(found.pairs.size(), 0);
    for (const contactPair& p : found.pairs)
    {
        EXPECT_EQ(p.wall, 0);
        EXPECT_NEAR(p.gap, surfaces.points()[p.node].y() + 1.1, 1e-14);
        EXPECT_LT(p.gap, 0.2);
    }
    EXPECT_THROW(contactWall(Zero, Zero), Foam::error);
}


TEST(ContactSearch, medialAxisRefusesSelfContact)
{
    EXPECT_NO_THROW(searchOf("type medialAxis; selfContact no;"));
    EXPECT_THROW(searchOf("type medialAxis; selfContact yes;"), IOerror);
}


TEST(ContactSearch, medialAxis)
{
    // Two discs 0.3 apart; the axis between them is the line x = 0
    surfaceSet surfaces(2);
    for (const scalar side : {-1, 1})
    {
        pointField x(circleNodes(1, 60));
        x += vector(1.15*side, 0, 0);
        surfaces.append(x, polygonFaces(60));
    }
    List<medialAxisPoint> axis;
    for (label i = -1; i <= 1; ++i)
    {
        axis.append
        (
            medialAxisPoint
            {
                point(0, 0.1*i, 0), 0.05, FixedList<label, 2>({0, 1})
            }
        );
    }

    contactPairs found(expectAxisPairs(surfaces, axis, 10, 0.51));

    axis[0].object[1] = 2;
    EXPECT_THROW
    (
        searchOf("type medialAxis;")->find
        (
            surfaces, UList<contactWall>(), axis, 0.4, found
        ),
        Foam::error
    );
}


TEST(ContactSearch, selfContact)
{
    // A letter C with a mouth 0.2 wide, its corners far from the mouth rounded
    // by nodes 0.1 apart
    const pointField corners
    ({
        {0, 0, 0}, {2, 0, 0}, {2, 0.4, 0}, {0.5, 0.4, 0},
        {0.5, 0.6, 0}, {2, 0.6, 0}, {2, 1, 0}, {0, 1, 0}
    });
    DynamicList<point> nodes;
    forAll(corners, i)
    {
        const vector edge(corners[(i + 1) % 8] - corners[i]);
        const label n = std::round(mag(edge)/0.1);
        for (label j = 0; j < n; ++j)
        {
            nodes.append(corners[i] + edge*j/n);
        }
    }
    surfaceSet surfaces(2);
    surfaces.append(pointField(nodes), polygonFaces(nodes.size()));

    const contactPairs found(contactsOf(surfaces, 0.3));
    EXPECT_GT(found.pairs.size(), 20);
    for (const contactPair& p : found.pairs)
    {
        const point& x = surfaces.points()[p.node];
        EXPECT_GE(x.x(), 0.5);
        EXPECT_TRUE(mag(x.y() - 0.4) < 1e-9 || mag(x.y() - 0.6) < 1e-9);
        EXPECT_NEAR(p.gap, 0.2, 1e-9);
    }

    EXPECT_EQ(contactsOf(surfaces, 0.3, "selfContact no;").pairs.size(), 0);

    surfaceSet disc(2);
    disc.append(circleNodes(1, 30), polygonFaces(30));
    EXPECT_EQ(contactsOf(disc, 0.8, "selfContact yes;").pairs.size(), 0);
}


TEST(ContactSearch, costIsLinear)
{
    autoPtr<contactSearch> search(searchOf(""));
    const surfaceSet few(lattice(13, 20, 2.2)), many(lattice(39, 20, 2.2));
    const scalar small = seconds(search(), few);
    const scalar large = seconds(search(), many);
    autoPtr<contactSearch> others(searchOf("selfContact no;"));
    const scalar withoutSelf = seconds(others(), many);
    RecordProperty("seconds_3380_nodes", std::to_string(small));
    RecordProperty("seconds_30420_nodes", std::to_string(large));
    std::cout
        << "search: 3,380 nodes " << small << " s, 30,420 nodes " << large
        << " s, " << withoutSelf << " s without self contact" << std::endl;

    // 9 times the nodes; n^2 would be 81, caches may cost a factor of two
    EXPECT_LT(large, 25*small);
}


TEST(ContactSearch, badInput)
{
    EXPECT_THROW(searchOf("type surfaceCells;"), Foam::IOerror);
    EXPECT_THROW(searchOf("selfcontact yes;"), Foam::IOerror);
}


// ************************************************************************* //
