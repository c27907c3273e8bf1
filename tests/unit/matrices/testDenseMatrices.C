// SPDX-License-Identifier: GPL-3.0-or-later

#include "columnBasis.H"
#include "denseCholesky.H"
#include "densePanels.H"
#include "bodyFreedom.H"
#include "rigidModes.H"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Some numbers between -1 and 1, the same on every run
Eigen::MatrixXd numbers(const label nRows, const label nColumns)
{
    Eigen::MatrixXd result(nRows, nColumns);
    unsigned state = 1;
    for (label i = 0; i < result.size(); ++i)
    {
        state = 1664525*state + 1013904223;
        result.data()[i] = 2.0*state/4294967296.0 - 1;
    }
    return result;
}


//- Symmetric, positive definite and full
Eigen::MatrixXd symmetric(const label n)
{
    const Eigen::MatrixXd a(numbers(n, n));
    return a*a.transpose() + Eigen::MatrixXd::Identity(n, n)*n/10;
}


//- Sizes around those of tiles and of groups of panels
const std::vector<label> sizes{1, 7, 8, 9, 24, 25, 40, 131, 168};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(denseMatrices, choleskySolvesAnyNumberOfColumns)
{
    for (const label n : sizes)
    {
        Eigen::MatrixXd A(symmetric(n));
        denseCholesky matrix, factor;
        matrix.reset(A);
        factor.reset(matrix, 2);
        factor.add(0, n/2, 0.25);
        A *= 2;
        A(0, n/2) += 0.25;
        if (n/2 != 0)
        {
            A(n/2, 0) += 0.25;
        }
        ASSERT_TRUE(factor.factor());

        for (const label nColumns : {1, 3, 5, 27})
        {
            Eigen::MatrixXd x(Eigen::MatrixXd::Zero(factor.nRows(), nColumns));
            const Eigen::MatrixXd b(numbers(n, nColumns));
            x.topRows(n) = b;
            factor.solve(nColumns, x.data());
            EXPECT_LT
            (
                (A*x.topRows(n) - b).cwiseAbs().maxCoeff(), 1e-12*n
            ) << n << " rows, " << nColumns << " columns";
        }
    }
}


TEST(denseMatrices, choleskyRefusesWhatIsNotPositiveDefinite)
{
    for (const label wrong : {0, 8, 30, 39})
    {
        Eigen::MatrixXd A(symmetric(40));
        A(wrong, wrong) = -1;
        denseCholesky factor;
        factor.reset(A);
        EXPECT_FALSE(factor.factor()) << wrong;
    }
}


TEST(denseMatrices, productsAreThoseOfEigen)
{
    for (const label n : sizes)
    {
        const Eigen::MatrixXd A(numbers(n, n));
        const densePanels panels(A);
        for (const label nColumns : {1, 3, 8, 21})
        {
            const Eigen::MatrixXd x(numbers(n, nColumns));
            Eigen::MatrixXd y;
            panels.multiply(x, y);
            EXPECT_LT((y - A*x).cwiseAbs().maxCoeff(), 1e-15*(n + 10))
                << n << " rows, " << nColumns << " columns";
        }
    }
}


TEST(denseMatrices, aColumnDoesNotDependOnThoseBesideIt)
{
    const label n = 131;
    const Eigen::MatrixXd A(symmetric(n));
    const densePanels panels(A);
    denseCholesky factor;
    factor.reset(A);
    ASSERT_TRUE(factor.factor());

    Eigen::MatrixXd x(Eigen::MatrixXd::Zero(factor.nRows(), 27));
    x.topRows(n) = numbers(n, 27);
    Eigen::MatrixXd together, alone;
    panels.multiply(x.topRows(n), together);
    Eigen::MatrixXd solved(x);
    factor.solve(27, solved.data());
    for (label c = 0; c < 27; ++c)
    {
        panels.multiply(x.col(c).head(n), alone);
        EXPECT_EQ(alone, together.col(c)) << c;
        Eigen::MatrixXd column(x.col(c));
        factor.solve(1, column.data());
        EXPECT_EQ(column, solved.col(c)) << c;
    }
}


TEST(denseMatrices, rotationsHaveABasisOfThreeColumns)
{
    // Three copies of a body; a mode that is no rotation adds three columns
    const label n = 40;
    const scalarField masses(n, 0.5);
    const Eigen::MatrixXd positions(numbers(n, 9));
    std::vector<Eigen::MatrixXd> modes
    (
        rigidModes::rotations(masses, positions, 3, bodyFreedom(3).rotations())
    );
    ASSERT_EQ(modes.size(), 3u);
    EXPECT_EQ(columnBasis(modes, 3).start(3), 9);
    modes.push_back(numbers(n, 9).cwiseAbs2());
    columnBasis basis(modes, 3);
    EXPECT_EQ(basis.start(1), 6);
    EXPECT_EQ(basis.start(3), 18);

    const Eigen::MatrixXd A(symmetric(n).topRows(7));
    std::vector<Eigen::MatrixXd> products(modes);
    basis.values() = (A*basis.values()).eval();
    basis.combine(products);
    for (size_t mode = 0; mode < modes.size(); ++mode)
    {
        const Eigen::MatrixXd expected(A*modes[mode]);
        EXPECT_LT
        (
            (products[mode] - expected).cwiseAbs().maxCoeff(),
            1e-13*expected.cwiseAbs().maxCoeff()
        ) << mode;
    }
}


TEST(denseMatrices, aCopysBasisDoesNotDependOnTheOthers)
{
    const scalarField masses(30, 1.0);
    const Eigen::MatrixXd positions(numbers(30, 9));
    std::vector<Eigen::MatrixXd> modes
    (
        rigidModes::rotations(masses, positions, 3, bodyFreedom(3).rotations())
    );
    columnBasis all(modes, 3);
    for (Eigen::MatrixXd& mode : modes)
    {
        mode = mode.middleCols(3, 3).eval();
    }
    columnBasis one(modes, 3);
    EXPECT_EQ(one.values(), all.values().middleCols(3, 3));
}


TEST(denseMatrices, modesOfZeroHaveNoBasis)
{
    std::vector<Eigen::MatrixXd> modes(2, Eigen::MatrixXd::Zero(5, 3));
    columnBasis basis(modes, 3);
    EXPECT_EQ(basis.start(1), 0);
    basis.combine(modes);
    EXPECT_EQ(modes[1], Eigen::MatrixXd::Zero(5, 3));
}


// ************************************************************************* //
