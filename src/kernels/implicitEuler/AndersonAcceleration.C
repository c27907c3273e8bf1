// SPDX-License-Identifier: GPL-3.0-or-later

#include "AndersonAcceleration.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int lanes>
void Foam::fsi::AndersonAcceleration::setProducts(const scalarField& f)
{
    laneArray<lanes> sums[kept];
    const scalarField* r[kept];
    for (label back = 0; back < kept; ++back)
    {
        sums[back] = laneArray<lanes>::Zero();
        r[back] = &residuals_[place(min(back, n_))];
    }
    for (label i = 0; i < size_/lanes; ++i)
    {
        const laneArray<lanes> fi = at<lanes>(f, i);
        sums[0] += fi*at<lanes>(*r[0], i);
        sums[1] += fi*at<lanes>(*r[1], i);
        sums[2] += fi*at<lanes>(*r[2], i);
    }
    for (label back = 0; back <= min(n_, kept - 1); ++back)
    {
        for (label lane = 0; lane < lanes; ++lane)
        {
            products_[place(0)][place(back)][lane] = sums[back][lane];
            products_[place(back)][place(0)][lane] = sums[back][lane];
        }
    }
}


void Foam::fsi::AndersonAcceleration::coefficients
(
    const label lane,
    scalar& c1,
    scalar& c2
) const
{
    const auto product = [&](const label i, const label j)
    {
        return products_[place(i)][place(j)][lane];
    };
    // (r_k - r_i) A^-1 (r_k - r_j), and that of r_k with r_k - r_i
    const auto matrix = [&](const label i, const label j)
    {
        return product(0, 0) - product(0, i) - product(0, j) + product(i, j);
    };

    c1 = 0;
    c2 = 0;
    const scalar least = 1e-12*product(0, 0);
    if (n_ == 0 || !(matrix(1, 1) > least))
    {
        return;
    }
    const scalar b1 = product(0, 0) - product(0, 1);
    c1 = b1/matrix(1, 1);
    if (n_ > 1)
    {
        const scalar b2 = product(0, 0) - product(0, 2);
        const scalar determinant =
            matrix(1, 1)*matrix(2, 2) - sqr(matrix(1, 2));
        if (determinant > 1e-8*matrix(1, 1)*matrix(2, 2))
        {
            c1 = (b1*matrix(2, 2) - b2*matrix(1, 2))/determinant;
            c2 = (b2*matrix(1, 1) - b1*matrix(1, 2))/determinant;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::AndersonAcceleration::start(const label size)
{
    n_ = 0;
    size_ = size;
    for (label i = 0; i < kept; ++i)
    {
        // Never made smaller, so that steps do not allocate
        if (residuals_[i].size() < size)
        {
            residuals_[i].setSize(size);
            targets_[i].setSize(size);
        }
    }
}


void Foam::fsi::AndersonAcceleration::keepResidual(const scalarField& r)
{
    std::copy_n(r.cbegin(), size_, residuals_[place(0)].begin());
}


template<int lanes>
void Foam::fsi::AndersonAcceleration::step
(
    const laneArray<lanes>& b,
    const scalarField& f,
    scalarField& x
)
{
    setProducts<lanes>(f);
    laneArray<lanes> c1, c2;
    for (label lane = 0; lane < lanes; ++lane)
    {
        coefficients(lane, c1[lane], c2[lane]);
    }

    scalarField& present = targets_[place(0)];
    const scalarField& last = targets_[place(min(n_, 1))];
    const scalarField& before = targets_[place(min(n_, 2))];
    for (label i = 0; i < size_/lanes; ++i)
    {
        const laneArray<lanes> g = at<lanes>(x, i) + b*at<lanes>(f, i);
        to<lanes>(present, i) = g;
        to<lanes>(x, i) =
            g
          - c1*(g - at<lanes>(last, i))
          - c2*(g - at<lanes>(before, i));
    }
    ++n_;
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    template void AndersonAcceleration::step<1>
    (const laneArray<1>&, const scalarField&, scalarField&);
    template void AndersonAcceleration::step<2>
    (const laneArray<2>&, const scalarField&, scalarField&);
    template void AndersonAcceleration::step<4>
    (const laneArray<4>&, const scalarField&, scalarField&);
    template void AndersonAcceleration::step<8>
    (const laneArray<8>&, const scalarField&, scalarField&);
}
}


// ************************************************************************* //
