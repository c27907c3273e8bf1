// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmFactor.H"
#include "laneCholesky.H"
#include "laneReference.H"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Values that differ from place to place
static scalarField samples(const label n, const scalar shift)
{
    scalarField values(n);
    forAll(values, i)
    {
        values[i] = Foam::sin(7.3*i + shift) + 0.2*shift;
    }
    return values;
}


//- Each operation gives in each lane what it gives for scalars
template<int lanes>
static void checkOperations()
{
    const scalarField x(samples(2*lanes, 1)), y(samples(2*lanes, 2));
    const laneArray<lanes> a(at<lanes>(x, 1)), b(at<lanes>(y, 0));
    scalarField result(2*lanes, Zero);
    to<lanes>(result, 1) = 2*a/b - b*a + 1;
    to<lanes>(result, 1) += a;
    to<lanes>(result, 1) -= b;

    const laneArray<lanes> root((a*a).sqrt());
    for (label lane = 0; lane < lanes; ++lane)
    {
        const scalar p = x[lanes + lane], q = y[lane];
        EXPECT_EQ(result[lane], 0);
        EXPECT_EQ(result[lanes + lane], 2*p/q - q*p + 1 + p - q);
        EXPECT_EQ(root[lane], Foam::sqrt(p*p));
        EXPECT_EQ(a.abs()[lane], mag(p));
        EXPECT_EQ((-a)[lane], -p);
        EXPECT_EQ(a.min(b)[lane], Foam::min(p, q));
        EXPECT_EQ(a.max(0.1)[lane], Foam::max(p, scalar(0.1)));
    }
    EXPECT_TRUE((a*a).positive());

    // One that is not positive shows in any lane
    for (label lane = 0; lane < lanes; ++lane)
    {
        laneArray<lanes> c(1);
        c[lane] = 0;
        EXPECT_FALSE(c.positive());
    }
}


//- A positive definite matrix of a ring of nodes with a few couplings across
static Eigen::SparseMatrix<double> ringMatrix(const label n)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (label i = 0; i < n; ++i)
    {
        entries.emplace_back(i, i, 5 + 0.1*i);
        for (const label step : {1, 3})
        {
            const label j = (i + step) % n;
            entries.emplace_back(i, j, -0.7/step);
            entries.emplace_back(j, i, -0.7/step);
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}


//- Value that is added to the matrix of a lane at nodes 2 and 5
static scalar added(const label lane)
{
    return 0.3 + 0.2*lane;
}


//- Solutions of each lane are those of its own matrix
static void checkSolutions(const int lanes, const label nComponents)
{
    const label n = 11;
    const scalar scale = 1.5;
    const admmFactor pattern(ringMatrix(n), n, 1);
    laneCholesky factors;
    factors.reset(pattern, scale, lanes);
    for (label lane = 0; lane < lanes; ++lane)
    {
        factors.add(lane, 2, 2, added(lane));
        factors.add(lane, 2, 5, -added(lane));
        factors.add(lane, 5, 5, added(lane));
    }
    ASSERT_TRUE(factors.factor());

    const scalarField b(samples(lanes*nComponents*n, 0));
    scalarField rows(b);
    factors.solve(rows.data(), nComponents);
    for (label lane = 0; lane < lanes; ++lane)
    {
        Eigen::MatrixXd matrix(scale*Eigen::MatrixXd(pattern.matrix()));
        matrix(2, 2) += added(lane);
        matrix(5, 5) += added(lane);
        matrix(2, 5) -= added(lane);
        matrix(5, 2) -= added(lane);
        const auto place = [&](const label node, const label cmpt)
        {
            return
                lanes*(nComponents*pattern.rowOf()[node] + cmpt) + lane;
        };
        for (label cmpt = 0; cmpt < nComponents; ++cmpt)
        {
            Eigen::VectorXd right(n);
            for (label node = 0; node < n; ++node)
            {
                right[node] = b[place(node, cmpt)];
            }
            const Eigen::VectorXd x(matrix.llt().solve(right));
            for (label node = 0; node < n; ++node)
            {
                EXPECT_NEAR(rows[place(node, cmpt)], x[node], 1e-14);
            }
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::fsi;

TEST(lanes, operateAsScalarsDo)
{
    checkOperations<1>();
    checkOperations<2>();
    checkOperations<4>();
    checkOperations<8>();
    checkOperations<16>();
}


TEST(lanes, solveEachItsOwnMatrix)
{
    for (const int lanes : {1, 2, 4, 8})
    {
        checkSolutions(lanes, 2);
        checkSolutions(lanes, 3);
    }
}


TEST(lanes, findOneMatrixThatIsNotPositiveDefinite)
{
    const admmFactor pattern(ringMatrix(11), 11, 1);
    for (int lane = 0; lane < 8; ++lane)
    {
        laneCholesky factors;
        factors.reset(pattern, 1, 8);
        factors.add(lane, 4, 4, -20);
        EXPECT_FALSE(factors.factor());
    }
}


TEST(lanes, multiplyAnyNumberOfColumns)
{
    const label n = 11;
    const admmFactor factor(ringMatrix(n), n, 1);
    typedef Eigen::SparseMatrix<double>::InnerIterator inner;
    for (const label nColumns : {1, 2, 3, 7, 8, 16, 17, 37})
    {
        const scalarField values(samples(n*nColumns, 3));
        const Eigen::Map<const Eigen::MatrixXd> x
        (
            values.cdata(),
            n,
            nColumns
        );
        const Eigen::MatrixXd result(factor.multiply(x));
        ASSERT_EQ(result.cols(), nColumns);

        // The result is equal to the last bit whatever registers are used
        for (label column = 0; column < nColumns; ++column)
        {
            for (label i = 0; i < n; ++i)
            {
                scalar sum = 0;
                for (inner it(factor.matrix(), i); it; ++it)
                {
                    sum += it.value()*x(it.row(), column);
                }
                EXPECT_EQ(result(i, column), sum);
            }
        }
    }
}


// ************************************************************************* //
