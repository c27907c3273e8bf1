// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "laneDomains.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Bound of the second derivative of (det F - 1)^2/2 over all directions
template<int lanes>
[[gnu::always_inline]]
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
[[gnu::always_inline]]
static inline laneArray<lanes> updateDual
(
    const laneArray<lanes>& dual,
    const laneReference<lanes> u
)
{
    if (step == admmStep::force)
    {
        return -dual;
    }
    if (step == admmStep::start)
    {
        u = dual;
        return -dual;
    }
    const laneArray<lanes> result = u.values() - 2*dual;
    u = dual;
    return result;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int lanes, Foam::fsi::admmStep step>
[[gnu::always_inline]]
inline void Foam::fsi::admmSolver::springStep()
{
    typedef laneArray<lanes> array;

    forAll(springWeights_, springi)
    {
        const label a = springRows_[2*springi];
        const label b = springRows_[2*springi + 1];
        const auto ux = to<lanes>(springDual_, 2*springi);
        const auto uy = to<lanes>(springDual_, 2*springi + 1);

        array yx = difference<lanes>(start_, change_, a, b, 0);
        array yy = difference<lanes>(start_, change_, a, b, 1);
        if (step == admmStep::local)
        {
            yx += ux.values();
            yy += uy.values();
        }

        // u over y, which is D x at the start
        const array length = (yx*yx + yy*yy).sqrt().max(VSMALL);
        const array fromRest =
            (1 - at<lanes>(restLengths_, springi)/length)
           *(step == admmStep::local ? springFraction_ : springRatio_);

        const array gx = updateDual<step, lanes>(fromRest*yx, ux);
        const array gy = updateDual<step, lanes>(fromRest*yy, uy);

        const scalar weight = springWeights_[springi];
        to<lanes>(residual_, 2*a) -= weight*gx;
        to<lanes>(residual_, 2*a + 1) -= weight*gy;
        to<lanes>(residual_, 2*b) += weight*gx;
        to<lanes>(residual_, 2*b + 1) += weight*gy;
    }
}


template<int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::admmSolver::setCurrent(const scalarField& from)
{
    for (label place = 0; place < 2*masses_.size(); ++place)
    {
        to<lanes>(current_, place) =
            at<lanes>(from, place) + at<lanes>(change_, place);
    }
}


template<int lanes, Foam::fsi::admmStep step>
[[gnu::always_inline]]
inline void Foam::fsi::admmSolver::areaStep()
{
    typedef laneArray<lanes> array;
    const strainDomains& domains = shape_.elementTerm().areaDomains();
    array stretch = array::Zero();

    forAll(areaWeights_, domaini)
    {
        array F[4];
        deformation<lanes>(domains, domaini, areaRows_, current_, F);
        F[0] += 1;
        F[3] += 1;
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
                F[i] += at<lanes>(areaDual_, 4*domaini + i);
            }
            volumeTerm::toLocalStep
            (
                F[0], F[1], F[2], F[3], shape_.admm().areaWeight
            );
        }

        array g[4];
        for (int i = 0; i < 4; ++i)
        {
            const auto u = to<lanes>(areaDual_, 4*domaini + i);
            g[i] = areaWeights_[domaini]*updateDual<step, lanes>(F[i], u);
        }
        spread<lanes>(domains, domaini, areaRows_, g, residual_);
    }
    to<lanes>(stretch_, 0) = stretch;
}


template<int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::admmSolver::shearStep()
{
    typedef laneArray<lanes> array;
    const strainDomains& domains = shape_.elementTerm().shearDomains();

    forAll(shearWeights_, domaini)
    {
        array F[4];
        deformation<lanes>(domains, domaini, shearRows_, current_, F);

        // F less its cofactors is twice the part that is not conformal
        const scalar weight = -0.5*shearWeights_[domaini];
        const array c = weight*(F[0] - F[3]), d = weight*(F[1] + F[2]);
        const array P[4] = {c, d, d, -c};
        spread<lanes>(domains, domaini, shearRows_, P, residual_);
    }
}


template<int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::admmSolver::viscousStep()
{
    typedef laneArray<lanes> array;
    const strainDomains& domains = shape_.elementTerm().shearDomains();

    forAll(viscousWeights_, domaini)
    {
        array P[4];
        deformation<lanes>(domains, domaini, shearRows_, current_, P);
        for (array& part : P)
        {
            part *= -viscousWeights_[domaini];
        }
        spread<lanes>(domains, domaini, shearRows_, P, residual_);
    }
}


template<int lanes, Foam::fsi::admmStep step>
[[gnu::always_inline]]
inline void Foam::fsi::admmSolver::elementStep()
{
    setCurrent<lanes>(displacement_);
    areaStep<lanes, step>();
    shearStep<lanes>();
    if (step != admmStep::start && !viscousWeights_.empty())
    {
        setCurrent<lanes>(lessDrift_);
        viscousStep<lanes>();
    }
}


template<int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::admmSolver::localStep(const admmStep step)
{
    switch (step)
    {
        case admmStep::start:
            springStep<lanes, admmStep::start>();
            elementStep<lanes, admmStep::start>();
            break;
        case admmStep::local:
            springStep<lanes, admmStep::local>();
            elementStep<lanes, admmStep::local>();
            break;
        case admmStep::force:
            springStep<lanes, admmStep::force>();
            elementStep<lanes, admmStep::force>();
            break;
    }
}


FSI_AVX2_CLONES
void Foam::fsi::admmSolver::localStep(const int lanes, const admmStep step)
{
    switch (lanes)
    {
        case 8: localStep<8>(step); break;
        case 4: localStep<4>(step); break;
        case 2: localStep<2>(step); break;
        default: localStep<1>(step);
    }
}


// ************************************************************************* //
