// SPDX-License-Identifier: GPL-3.0-or-later

#include "angularMomentum.H"
#include "laneReference.H"

#include <Eigen/Dense>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace angularMomentum
{

//- Mean of node values, weighted with the masses
template<int lanes>
static laneArray<lanes> massMean
(
    const scalarField& values,
    const copyBlock& block,
    const int i
)
{
    laneArray<lanes> mean = laneArray<lanes>::Zero();
    forAll(block.masses, row)
    {
        mean += block.masses[row]*at<lanes>(values, block.nDims*row + i);
    }
    return mean/sum(block.masses);
}


//- Centres of mass at the start and at the end of the step
template<int nDims, int lanes>
struct centres
{
    laneArray<lanes> start[nDims];
    laneArray<lanes> end[nDims];

    explicit centres(const copyBlock& block)
    {
        for (int i = 0; i < nDims; ++i)
        {
            start[i] = massMean<lanes>(block.start, block, i);
            end[i] = start[i] + massMean<lanes>(block.change, block, i);
        }
    }

    //- x^n - c^n and x - c of a row
    void arms
    (
        const copyBlock& block,
        const label row,
        laneArray<lanes>* a,
        laneArray<lanes>* e
    ) const
    {
        for (int i = 0; i < nDims; ++i)
        {
            const label place = nDims*row + i;
            a[i] = at<lanes>(block.start, place) - start[i];
            e[i] =
                at<lanes>(block.start, place) + at<lanes>(block.change, place)
              - end[i];
        }
    }
};


//- Turn in the plane
template<int lanes>
static void restorePlanar(copyBlock& block, const bool conserving)
{
    typedef laneArray<lanes> array;
    const centres<2, lanes> centre(block);

    // Sums of m w.e, m w x e, and m a x (x~ - x^n)
    array a[2], e[2];
    array dot = array::Zero(), cross = array::Zero(), target = array::Zero();
    forAll(block.masses, row)
    {
        centre.arms(block, row, a, e);
        const auto ix = at<lanes>(block.inertial, 2*row);
        const auto iy = at<lanes>(block.inertial, 2*row + 1);
        const scalar m = block.masses[row];
        if (conserving)
        {
            target += m*(a[0]*iy - a[1]*ix);
        }
        else
        {
            a[0] += ix;
            a[1] += iy;
        }
        dot += m*(a[0]*e[0] + a[1]*e[1]);
        cross += m*(a[0]*e[1] - a[1]*e[0]);
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

    forAll(block.masses, row)
    {
        centre.arms(block, row, a, e);
        to<lanes>(block.change, 2*row) -= versine*e[0] + sine*e[1];
        to<lanes>(block.change, 2*row + 1) += sine*e[0] - versine*e[1];
    }
}


//- R - 1 of the rotation vector d
static Eigen::Matrix3d turnLessUnit(const Eigen::Vector3d& d)
{
    const scalar angle = d.norm();
    Eigen::Matrix3d cross;
    cross << 0, -d[2], d[1], d[2], 0, -d[0], -d[1], d[0], 0;
    if (angle < 1e-8)
    {
        return cross + 0.5*cross*cross;
    }
    const scalar versine = 2*sqr(std::sin(0.5*angle)/angle);
    return std::sin(angle)/angle*cross + versine*cross*cross;
}


//- R - 1 such that N R^T has the axial vector t
static Eigen::Matrix3d turnFor(Eigen::Matrix3d N, const Eigen::Vector3d& t)
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
    for (label iteration = 0; iteration < 30; ++iteration)
    {
        const Eigen::Vector3d axial
        (
            N(1, 2) - N(2, 1), N(2, 0) - N(0, 2), N(0, 1) - N(1, 0)
        );
        const Eigen::Matrix3d jacobian =
            N.trace()*Eigen::Matrix3d::Identity() - N.transpose();
        Eigen::Vector3d delta = jacobian.partialPivLu().solve(t - axial);

        // A rotation of half a radian at most, should N be odd
        const scalar angle = delta.norm();
        if (!(angle > 1e-15))
        {
            break;
        }
        delta *= min(scalar(1), 0.5/angle);
        const Eigen::Matrix3d more = turnLessUnit(delta);
        N += (N*more.transpose()).eval();
        turn += (more + more*turn).eval();
    }
    return turn;
}


//- Turn all lanes
template<int lanes>
static void turnsFor
(
    const laneArray<lanes>* N,
    const laneArray<lanes>* target,
    laneArray<lanes>* turn
)
{
    for (int lane = 0; lane < lanes; ++lane)
    {
        Eigen::Matrix3d matrix;
        Eigen::Vector3d t;
        for (int i = 0; i < 3; ++i)
        {
            t[i] = target[i][lane];
            for (int j = 0; j < 3; ++j)
            {
                matrix(i, j) = N[3*i + j][lane];
            }
        }
        matrix = turnFor(matrix, t);
        for (int i = 0; i < 9; ++i)
        {
            turn[i][lane] = matrix(i/3, i % 3);
        }
    }
}


//- Turn in space
template<int lanes>
static void restoreSpatial(copyBlock& block, const bool conserving)
{
    typedef laneArray<lanes> array;
    const centres<3, lanes> centre(block);

    array a[3], e[3], N[9], target[3];
    std::fill(N, N + 9, array::Zero());
    std::fill(target, target + 3, array::Zero());
    forAll(block.masses, row)
    {
        centre.arms(block, row, a, e);
        const scalar m = block.masses[row];
        for (int i = 0; i < 3; ++i)
        {
            if (conserving)
            {
                const int j = (i + 1) % 3, k = (i + 2) % 3;
                target[i] += m
                   *(
                        a[j]*at<lanes>(block.inertial, 3*row + k)
                      - a[k]*at<lanes>(block.inertial, 3*row + j)
                    );
            }
        }
        for (int i = 0; i < 3; ++i)
        {
            if (!conserving)
            {
                a[i] += at<lanes>(block.inertial, 3*row + i);
            }
            for (int j = 0; j < 3; ++j)
            {
                N[3*i + j] += m*(a[i]*e[j]);
            }
        }
    }

    array turn[9];
    turnsFor<lanes>(N, target, turn);
    forAll(block.masses, row)
    {
        centre.arms(block, row, a, e);
        for (int i = 0; i < 3; ++i)
        {
            to<lanes>(block.change, 3*row + i) +=
                turn[3*i]*e[0] + turn[3*i + 1]*e[1] + turn[3*i + 2]*e[2];
        }
    }
}

} // End namespace angularMomentum
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int lanes>
void Foam::fsi::angularMomentum::restore
(
    copyBlock& block,
    const bool conserving
)
{
    if (block.nDims == 2)
    {
        restorePlanar<lanes>(block, conserving);
    }
    else
    {
        restoreSpatial<lanes>(block, conserving);
    }
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace angularMomentum
{
    template void restore<1>(copyBlock&, const bool);
    template void restore<2>(copyBlock&, const bool);
    template void restore<4>(copyBlock&, const bool);
    template void restore<8>(copyBlock&, const bool);
}
}
}


// ************************************************************************* //
