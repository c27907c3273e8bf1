// SPDX-License-Identifier: GPL-3.0-or-later

#include "passAcceleration.H"
#include "sumOverRanks.H"

#include <Eigen/Dense>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::fsi::passAcceleration::factors() const
{
    const label n = label(passes_.size()) - 1;
    scalarList c(n, Zero);
    if (n == 0)
    {
        return c;
    }
    List<scalarField> d(n);
    for (label j = 0; j < n; ++j)
    {
        d[j] = passes_[j + 1].change - passes_[j].change;
    }
    DynamicList<scalar> products;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            products.append(sumProd(d[i], d[j]));
        }
        products.append(sumProd(d[i], passes_.back().change));
    }
    scalarField sums(products);
    sumOverRanks(sums);

    // In units of each difference's norm. Differences that others hold to 1e-4
    // get nothing: what the solvers leave would decide on their factors
    Eigen::MatrixXd A(n, n);
    Eigen::VectorXd b(n), scale(n);
    label k = 0;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            A(i, j) = A(j, i) = sums[k++];
        }
        b[i] = sums[k++];
        scale[i] = 1/(::sqrt(A(i, i)) + VSMALL);
    }
    A = (scale.asDiagonal()*A*scale.asDiagonal()).eval();
    b = scale.cwiseProduct(b).eval();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-8);
    solver.compute(A);
    const Eigen::VectorXd x(scale.cwiseProduct(solver.solve(b)));
    for (label i = 0; i < n; ++i)
    {
        c[i] = x[i];
    }
    return c;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::passAcceleration::next
(
    const scalarField& start,
    const scalarField& change
)
{
    passes_.push_back({start, change});
    if (label(passes_.size()) > depth_ + 1)
    {
        passes_.pop_front();
    }
    factors_ = factors();
    scalarField x(start + change);
    forAll(factors_, j)
    {
        const pass& before = passes_[j];
        const pass& after = passes_[j + 1];
        x -=
            factors_[j]
           *(
                after.start - before.start + after.change - before.change
            );
    }
    return x;
}


Foam::vectorField Foam::fsi::passAcceleration::beside(const vectorField& found)
{
    beside_.push_back(found);
    if (label(beside_.size()) > factors_.size() + 1)
    {
        beside_.pop_front();
    }
    vectorField x(found);
    forAll(factors_, j)
    {
        x -= factors_[j]*(beside_[j + 1] - beside_[j]);
    }
    return x;
}


// ************************************************************************* //
