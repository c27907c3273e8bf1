// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementForces.H"
#include "elementViscosity.H"
#include "laneDomains.H"
#include "shearTerm.H"
#include "UIndirectList.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- S, see above
template<int nDims, int lanes>
[[gnu::always_inline]]
static inline laneArray<lanes> largestSecondDerivative
(
    const laneArray<lanes>* F
)
{
    laneArray<lanes> C[nDims*nDims];
    volumeTerm::cofactors<nDims>(F, C);
    const laneArray<lanes> excess =
        (volumeTerm::determinant<nDims>(F, C) - 1).abs();
    if (nDims == 2)
    {
        return F[0]*F[0] + F[1]*F[1] + F[2]*F[2] + F[3]*F[3] + excess;
    }
    laneArray<lanes> squares(0), cofactorSquares(0);
    for (int i = 0; i < nDims*nDims; ++i)
    {
        squares += F[i]*F[i];
        cofactorSquares += C[i]*C[i];
    }
    return cofactorSquares + (4.0/3.0*squares).sqrt()*excess;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::setCurrent
(
    const scalarField& from,
    const scalarField& change
)
{
    const label n = shape_.nDims()*shape_.nNodes();
    for (label place = 0; place < n; ++place)
    {
        to<lanes>(current_, place) =
            at<lanes>(from, place) + at<lanes>(change, place);
    }
}


template<int nDims, int lanes, Foam::fsi::dualStep step>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::volumes(copyBlock& block)
{
    typedef laneArray<lanes> array;
    const int n = nDims*nDims;
    const volumeTerm& term = shape_.elementTerm();
    const strainDomains& domains = term.volumeDomains();
    const scalar weight = shape_.admm().areaWeight;
    const scalar shearPart = term.shearPart();
    array stretch = array::Zero();

    forAll(volumeWeights_, domaini)
    {
        array F[n], u[n];
        deformation<nDims>(domains, domaini, volumeRows_, current_, F);
        for (int i = 0; i < nDims; ++i)
        {
            F[(nDims + 1)*i] += 1;
        }
        if (step == dualStep::force)
        {
            stretch = stretch.max(largestSecondDerivative<nDims>(F));
        }
        if (step != dualStep::local)
        {
            volumeTerm::toGradient<nDims>(F, shearPart);
            for (int i = 0; i < n; ++i)
            {
                u[i] = F[i]/weight;
            }
        }
        else
        {
            for (int i = 0; i < n; ++i)
            {
                u[i] = at<lanes>(dual_, n*domaini + i);
            }
            volumeTerm::toLocalStep<nDims>(F, u, weight, shearPart);
        }

        for (int i = 0; i < n; ++i)
        {
            const auto old = to<lanes>(dual_, n*domaini + i);
            u[i] = volumeWeights_[domaini]*updateDual<step, lanes>(u[i], old);
        }
        spread<nDims>(domains, domaini, volumeRows_, u, block.residual);
    }
    to<lanes>(stretch_, 0) = stretch;
}


template<int nDims, int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::shear(copyBlock& block)
{
    typedef laneArray<lanes> array;
    const strainDomains& domains = shape_.elementTerm().shearDomains();

    forAll(shearWeights_, domaini)
    {
        array F[nDims*nDims];
        deformation<nDims>(domains, domaini, shearRows_, current_, F);
        shearTerm::toGradient<nDims>(F);
        for (array& part : F)
        {
            part *= -shearWeights_[domaini];
        }
        spread<nDims>(domains, domaini, shearRows_, F, block.residual);
    }
}


template<int nDims, int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::viscous(copyBlock& block)
{
    typedef laneArray<lanes> array;
    const strainDomains& domains = shape_.elementTerm().shearDomains();

    forAll(viscousWeights_, domaini)
    {
        array P[nDims*nDims];
        deformation<nDims>(domains, domaini, shearRows_, current_, P);
        for (array& part : P)
        {
            part *= -viscousWeights_[domaini];
        }
        spread<nDims>(domains, domaini, shearRows_, P, block.residual);
    }
}


template<int nDims, int lanes, Foam::fsi::dualStep step>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::add(copyBlock& block)
{
    setCurrent<lanes>(block.displacement, block.change);
    volumes<nDims, lanes, step>(block);
    shear<nDims, lanes>(block);
    if (step != dualStep::start && !viscousWeights_.empty())
    {
        setCurrent<lanes>(block.lessDrift, block.change);
        viscous<nDims, lanes>(block);
    }
}


template<int nDims, int lanes>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::add
(
    const dualStep step,
    copyBlock& block
)
{
    switch (step)
    {
        case dualStep::start:
            add<nDims, lanes, dualStep::start>(block); break;
        case dualStep::local:
            add<nDims, lanes, dualStep::local>(block); break;
        case dualStep::force:
            add<nDims, lanes, dualStep::force>(block); break;
    }
}


template<int nDims>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::add
(
    const int lanes,
    const dualStep step,
    copyBlock& block
)
{
    switch (lanes)
    {
        case 8: add<nDims, 8>(step, block); break;
        case 4: add<nDims, 4>(step, block); break;
        case 2: add<nDims, 2>(step, block); break;
        default: add<nDims, 1>(step, block);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::elementForces::elementForces(const shapeTemplate& shape)
:
    shape_(shape),
    stretch_(8, Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::elementForces::setFactor(const admmFactor& factor)
{
    const volumeTerm& term = shape_.elementTerm();
    const labelList& rowOf = factor.rowOf();
    volumeRows_ = UIndirectList<label>(rowOf, term.volumeDomains().nodes())();
    shearRows_ = UIndirectList<label>(rowOf, term.shearDomains().nodes())();

    const scalar dt = factor.deltaT();
    volumeWeights_ =
        sqr(dt)*shape_.admm().areaWeight*term.stiffness()
       *term.volumeDomains().volumes();
    shearWeights_.clear();
    if (shape_.shearModulus() > 0)
    {
        shearWeights_ =
            shearTerm::bound(shape_.nDims())*sqr(dt)*shape_.shearModulus()
           *term.shearDomains().volumes();
    }
    viscousWeights_.clear();
    if (shape_.viscosity() > 0)
    {
        viscousWeights_ =
            dt*elementViscosity::boundRatio*shape_.viscosity()
           *term.shearDomains().volumes();
    }
}


void Foam::fsi::elementForces::resize(const label lanes)
{
    const label nDims = shape_.nDims();
    const label n = nDims*lanes*shape_.nNodes();
    if (current_.size() < n)
    {
        current_.resize(n);
        dual_.resize
        (
            nDims*nDims*lanes*shape_.elementTerm().volumeDomains().size()
        );
    }
}


FSI_AVX2_CLONES
void Foam::fsi::elementForces::add
(
    const int lanes,
    const dualStep step,
    copyBlock& block
)
{
    if (block.nDims == 2)
    {
        add<2>(lanes, step, block);
    }
    else
    {
        add<3>(lanes, step, block);
    }
}


// ************************************************************************* //
