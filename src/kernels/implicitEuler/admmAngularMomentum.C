// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "admmLanes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Mean of node values, weighted with the masses
template<int lanes>
static laneArray<lanes> massMean
(
    const scalarField& values,
    const scalarField& masses,
    const int i
)
{
    laneArray<lanes> mean = laneArray<lanes>::Zero();
    forAll(masses, row)
    {
        mean += masses[row]*at<lanes>(values, 2*row + i);
    }
    return mean/sum(masses);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int lanes>
void Foam::fsi::admmSolver::restoreAngularMomentum()
{
    typedef laneArray<lanes> array;
    const bool conserving = shape_.admm().conserving;

    const array startX = massMean<lanes>(start_, masses_, 0);
    const array startY = massMean<lanes>(start_, masses_, 1);
    const array endX = startX + massMean<lanes>(change_, masses_, 0);
    const array endY = startY + massMean<lanes>(change_, masses_, 1);

    // With a = x^n - c^n, e = x - c and w = a (conserving) or x~ - c~:
    // sums of m w.e, m w x e, and m a x (x~ - x^n)
    array dot = array::Zero(), cross = array::Zero(), target = array::Zero();
    forAll(masses_, row)
    {
        const array ax = at<lanes>(start_, 2*row) - startX;
        const array ay = at<lanes>(start_, 2*row + 1) - startY;
        const array ex =
            at<lanes>(start_, 2*row) + at<lanes>(change_, 2*row) - endX;
        const array ey =
            at<lanes>(start_, 2*row + 1) + at<lanes>(change_, 2*row + 1) - endY;
        const auto ix = at<lanes>(inertial_, 2*row);
        const auto iy = at<lanes>(inertial_, 2*row + 1);

        const scalar m = masses_[row];
        array wx = ax, wy = ay;
        if (conserving)
        {
            target += m*(ax*iy - ay*ix);
        }
        else
        {
            wx += ix;
            wy += iy;
        }
        dot += m*(wx*ex + wy*ey);
        cross += m*(wx*ey - wy*ex);
    }

    // The turn t solves cross cos t + dot sin t = target
    array sine, versine;
    for (int lane = 0; lane < lanes; ++lane)
    {
        const scalar length = std::hypot(dot[lane], cross[lane]);
        const scalar part =
            max(min(target[lane]/length, scalar(1)), scalar(-1));
        const scalar turn =
            std::asin(part) - std::atan2(cross[lane], dot[lane]);
        sine[lane] = std::sin(turn);
        versine[lane] = 2*sqr(std::sin(0.5*turn));
    }

    forAll(masses_, row)
    {
        const array ex =
            at<lanes>(start_, 2*row) + at<lanes>(change_, 2*row) - endX;
        const array ey =
            at<lanes>(start_, 2*row + 1) + at<lanes>(change_, 2*row + 1) - endY;
        to<lanes>(change_, 2*row) -= versine*ex + sine*ey;
        to<lanes>(change_, 2*row + 1) += sine*ex - versine*ey;
    }
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    template void admmSolver::restoreAngularMomentum<1>();
    template void admmSolver::restoreAngularMomentum<2>();
    template void admmSolver::restoreAngularMomentum<4>();
    template void admmSolver::restoreAngularMomentum<8>();
}
}


// ************************************************************************* //
