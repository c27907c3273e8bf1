// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "admmLanes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Change of the edges of an element from E, times B, row by row: the
//  deformation gradient less the unit matrix
template<int lanes>
static inline void edgeGradient
(
    const scalarField& start,
    const scalarField& change,
    const label* rows,
    const scalar* E,
    const scalar* B,
    laneArray<lanes>* F
)
{
    for (int i = 0; i < 2; ++i)
    {
        const laneArray<lanes> d1 =
            difference<lanes>(start, change, rows[0], rows[1], i) - E[i];
        const laneArray<lanes> d2 =
            difference<lanes>(start, change, rows[0], rows[2], i) - E[2 + i];
        F[2*i] = d1*B[0] + d2*B[2];
        F[2*i + 1] = d1*B[1] + d2*B[3];
    }
}


//- Add weight*G^T g to the nodes of an element
template<int lanes>
static inline void spread
(
    const scalar weight,
    const laneArray<lanes>* g,
    const label* rows,
    const scalar* B,
    scalarField& residual
)
{
    for (int i = 0; i < 2; ++i)
    {
        const laneArray<lanes> h1 =
            weight*(g[2*i]*B[0] + g[2*i + 1]*B[1]);
        const laneArray<lanes> h2 =
            weight*(g[2*i]*B[2] + g[2*i + 1]*B[3]);
        at<lanes>(residual, 2*rows[0] + i) -= h1 + h2;
        at<lanes>(residual, 2*rows[1] + i) += h1;
        at<lanes>(residual, 2*rows[2] + i) += h2;
    }
}


//- Bound of the second derivative of (det F - 1)^2/2 over all directions
template<int lanes>
static inline laneArray<lanes> secondDerivative(const laneArray<lanes>* F)
{
    return
        F[0]*F[0] + F[1]*F[1] + F[2]*F[2] + F[3]*F[3]
      + (F[0]*F[3] - F[1]*F[2] - 1).abs();
}


//- Put a new dual variable u in the place of the old one. At the start u is
//  (dV/dz)/w^2 and -u is returned, later it is y - z and z - u - D x is. The
//  force needs no u
template<admmStep step, int lanes>
static inline laneArray<lanes> updateDual
(
    const laneArray<lanes>& dual,
    Eigen::Map<laneArray<lanes>> u
)
{
    if (step == admmStep::force)
    {
        return -dual;
    }
    if (step == admmStep::start)
    {
        u = dual;
        return -u;
    }
    const laneArray<lanes> result = u - 2*dual;
    u = dual;
    return result;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int lanes, Foam::fsi::admmStep step>
void Foam::fsi::admmSolver::springStep()
{
    typedef laneArray<lanes> array;

    forAll(springWeights_, springi)
    {
        const label a = springRows_[2*springi];
        const label b = springRows_[2*springi + 1];
        auto ux = at<lanes>(springDual_, 2*springi);
        auto uy = at<lanes>(springDual_, 2*springi + 1);

        array yx = difference<lanes>(start_, change_, a, b, 0);
        array yy = difference<lanes>(start_, change_, a, b, 1);
        if (step == admmStep::local)
        {
            yx += ux;
            yy += uy;
        }

        // u over y, which is D x at the start
        const array length = (yx*yx + yy*yy).sqrt().max(VSMALL);
        const array fromRest =
            (1 - at<lanes>(restLengths_, springi)/length)
           *(step == admmStep::local ? springFraction_ : springRatio_);

        const array gx = updateDual<step, lanes>(fromRest*yx, ux);
        const array gy = updateDual<step, lanes>(fromRest*yy, uy);

        const scalar weight = springWeights_[springi];
        at<lanes>(residual_, 2*a) -= weight*gx;
        at<lanes>(residual_, 2*a + 1) -= weight*gy;
        at<lanes>(residual_, 2*b) += weight*gx;
        at<lanes>(residual_, 2*b + 1) += weight*gy;
    }
}


template<int lanes>
void Foam::fsi::admmSolver::addViscous
(
    const label elementi,
    laneArray<lanes>* g
) const
{
    static const scalar atRest[4] = {0, 0, 0, 0};
    laneArray<lanes> rate[4];
    edgeGradient<lanes>
    (
        lessDrift_,
        change_,
        &elementRows_[3*elementi],
        atRest,
        &shape_.elementTerm().inverseEdges()[4*elementi],
        rate
    );
    for (int i = 0; i < 4; ++i)
    {
        g[i] -= viscousRatio_*rate[i];
    }
}


template<int lanes, Foam::fsi::admmStep step>
void Foam::fsi::admmSolver::elementStep()
{
    typedef laneArray<lanes> array;
    const volumeTerm& term = shape_.elementTerm();
    array stretch = array::Zero();

    forAll(elementWeights_, elementi)
    {
        const label* rows = &elementRows_[3*elementi];
        const scalar* E = &term.edges()[4*elementi];
        const scalar* B = &term.inverseEdges()[4*elementi];

        array F[4];
        edgeGradient<lanes>(start_, change_, rows, E, B, F);
        F[0] += 1;
        F[3] += 1;
        const array shear0 = 0.5*shearRatio_*(F[0] - F[3]);
        const array shear1 = 0.5*shearRatio_*(F[1] + F[2]);
        if (step == admmStep::force)
        {
            stretch = stretch.max(secondDerivative<lanes>(F));
        }
        if (step != admmStep::local)
        {
            volumeTerm::toGradient(F[0], F[1], F[2], F[3]);
            for (array& part : F)
            {
                part /= shape_.admm().areaWeight;
            }
        }
        else
        {
            for (int i = 0; i < 4; ++i)
            {
                F[i] += at<lanes>(elementDual_, 4*elementi + i);
            }
            volumeTerm::toLocalStep
            (
                F[0], F[1], F[2], F[3], shape_.admm().areaWeight
            );
        }

        array g[4];
        for (int i = 0; i < 4; ++i)
        {
            auto u = at<lanes>(elementDual_, 4*elementi + i);
            g[i] = updateDual<step, lanes>(F[i], u);
        }

        // F less its cofactors is twice the part of F that is not conformal
        g[0] -= shear0;
        g[1] -= shear1;
        g[2] -= shear1;
        g[3] += shear0;
        if (step != admmStep::start && viscousRatio_ > 0)
        {
            addViscous<lanes>(elementi, g);
        }

        spread<lanes>(elementWeights_[elementi], g, rows, B, residual_);
    }
    at<lanes>(stretch_, 0) = stretch;
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

#define makeSteps(lanes)                                                      \
    template void admmSolver::springStep<lanes, admmStep::start>();           \
    template void admmSolver::springStep<lanes, admmStep::local>();           \
    template void admmSolver::springStep<lanes, admmStep::force>();           \
    template void admmSolver::elementStep<lanes, admmStep::start>();          \
    template void admmSolver::elementStep<lanes, admmStep::local>();          \
    template void admmSolver::elementStep<lanes, admmStep::force>();

namespace Foam
{
namespace fsi
{
    makeSteps(1)
    makeSteps(2)
    makeSteps(4)
    makeSteps(8)
}
}

#undef makeSteps


// ************************************************************************* //
