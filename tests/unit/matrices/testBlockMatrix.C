// SPDX-License-Identifier: GPL-3.0-or-later

#include "blockCholesky.H"
#include "blockMatrix.H"
#include "innerFlow.H"
#include "membraneMatrix.H"
#include "samples/membraneSamples.H"

#include <gtest/gtest.h>
#include <random>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Entries of a positive definite matrix with blocks on the diagonal and for
//  some pairs of nodes; some entries come in two parts
blockPattern::entries randomEntries
(
    const label n,
    const label nPairs,
    std::mt19937& random
)
{
    std::uniform_real_distribution<scalar> value(-1, 1);
    std::uniform_int_distribution<label> node(0, n - 1);
    blockPattern::entries entries;
    for (label pairi = 0; pairi < nPairs; ++pairi)
    {
        // g g^T of four unknowns
        const label a = node(random), b = node(random);
        const label unknowns[4] = {a, n + a, b, n + b};
        const scalar g[4] =
            {value(random), value(random), value(random), value(random)};
        for (label i = 0; i < 4; ++i)
        {
            for (label j = 0; j < 4; ++j)
            {
                entries.emplace_back(unknowns[i], unknowns[j], g[i]*g[j]);
            }
        }
    }
    for (label i = 0; i < 2*n; ++i)
    {
        entries.emplace_back(i, i, 0.1);
    }
    return entries;
}


Eigen::MatrixXd dense(const label n, const blockPattern::entries& entries)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2*n, 2*n);
    for (const auto& entry : entries)
    {
        matrix(entry.row(), entry.col()) += entry.value();
    }
    return matrix;
}


//- Is this the inverse of a matrix between its first nB of n nodes?
void expectInverse
(
    const Eigen::MatrixXd& matrix,
    const Eigen::MatrixXd& part,
    const label nB
)
{
    const label n = matrix.rows()/2;
    const Eigen::MatrixXd inverse = matrix.inverse();
    for (label i = 0; i < 2*nB; ++i)
    {
        for (label j = 0; j < 2*nB; ++j)
        {
            EXPECT_NEAR
            (
                part(i, j),
                inverse(i % nB + n*(i/nB), j % nB + n*(j/nB)),
                1e-11*inverse.cwiseAbs().maxCoeff()
            );
        }
    }
}


//- Does a matrix of blocks do what the dense one does?
void expectSame(const label n, const blockPattern::entries& entries)
{
    blockMatrix blocks;
    blocks.setPattern(n, entries);
    blocks.set(entries);
    const Eigen::MatrixXd matrix = dense(n, entries);

    const Eigen::VectorXd x = Eigen::VectorXd::Random(2*n);
    Eigen::VectorXd y(2*n);
    blocks.multiply(x.data(), y.data());
    EXPECT_LT((y - matrix*x).norm(), 1e-13*y.norm());
    EXPECT_DOUBLE_EQ(blocks.diagonal(n - 1, 1), matrix(2*n - 1, 2*n - 1));

    blockCholesky factor;
    ASSERT_TRUE(factor.factor(blocks.pattern(), blocks.values()));
    factor.solve(y.data());
    EXPECT_LT((y - x).norm(), 1e-10*x.norm());
    expectInverse(matrix, factor.inverse(n), n);
    expectInverse(matrix, factor.inverse((n + 1)/2), (n + 1)/2);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(blockMatrix, solvesWhatTheDenseOneSolves)
{
    // From a few chains to a matrix without zeros
    std::mt19937 random(1);
    for (const label n : {1, 2, 7, 40})
    {
        for (const label nPairs : {label(0), n/2, n, 4*n, n*n})
        {
            SCOPED_TRACE(std::to_string(n) + " " + std::to_string(nPairs));
            expectSame(n, randomEntries(n, nPairs, random));
        }
    }
}


TEST(blockMatrix, aTreeHasNoFill)
{
    // A star, worst middle first: each end keeps its one block
    const label n = 30;
    blockPattern::entries entries;
    for (label i = 0; i < n; ++i)
    {
        entries.emplace_back(i, i, 1);
        entries.emplace_back(0, i, 1);
        entries.emplace_back(i, 0, 1);
    }
    EXPECT_EQ(blockPattern(n, entries).nBlocks(), 2*n - 1);
}


TEST(blockMatrix, takesNewValues)
{
    std::mt19937 random(2);
    const label n = 20;
    blockPattern::entries entries = randomEntries(n, 30, random);
    blockMatrix blocks;
    blocks.setPattern(n, entries);
    for (auto& entry : entries)
    {
        entry = {entry.row(), entry.col(), 2*entry.value()};
    }
    blocks.set(entries);
    blockCholesky factor;
    ASSERT_TRUE(factor.factor(blocks.pattern(), blocks.values()));
    expectInverse(dense(n, entries), factor.inverse(n), n);

    entries.pop_back();
    EXPECT_ANY_THROW(blocks.set(entries));
}


TEST(blockMatrix, refusesWhatItHasNoPlaceFor)
{
    blockPattern::entries entries;
    for (label i = 0; i < 6; ++i)
    {
        entries.emplace_back(i, i, i == 4 ? -1 : 1);
    }
    blockMatrix blocks;
    blocks.setPattern(3, entries);
    blocks.set(entries);
    blockCholesky factor;
    EXPECT_FALSE(factor.factor(blocks.pattern(), blocks.values()));

    const label a = blocks.pattern().place(0) > blocks.pattern().place(1);
    EXPECT_ANY_THROW(blocks.pattern().valueOf(1 - a, a));
    EXPECT_EQ(blocks.pattern().valueOf(a, 1 - a), -1);
}


TEST(blockMatrix, followsTheTrianglesOfTheFilling)
{
    auto shape = membraneOf("0.1 0.06", typical);
    auto group = cellOf(*shape);
    List<List<bodyElement>> triangles(1, group->elements(0));

    membraneMatrix kept(*shape);
    kept.prepare(1e-3, group->positions(), triangles);

    Eigen::MatrixXd x = group->positions();
    x.col(0) += 2*x.col(1);
    ASSERT_TRUE(innerFlow::renew(triangles[0], x, shape->nBoundaryNodes()));
    kept.prepare(1e-3, x, triangles);
    membraneMatrix fresh(*shape);
    fresh.prepare(1e-3, x, triangles);
    EXPECT_EQ(kept.boundaryInverse(0), fresh.boundaryInverse(0));
}


TEST(innerFlow, namesAMembraneThatCrossesItself)
{
    auto shape = membraneOf("0.1 0.06", typical);
    auto group = cellOf(*shape);
    List<bodyElement> triangles(group->elements(0));

    // Two opposite nodes of the outline change places
    Eigen::MatrixXd x = group->positions();
    x.row(0).swap(x.row(shape->nBoundaryNodes()/2));
    try
    {
        innerFlow::renew(triangles, x, shape->nBoundaryNodes());
        FAIL();
    }
    catch (const Foam::error& error)
    {
        EXPECT_NE(error.message().find("crosses itself"), string::npos);
    }
}


// ************************************************************************* //
