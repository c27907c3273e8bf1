// SPDX-License-Identifier: GPL-3.0-or-later

#include "elementForces.H"
#include "elementViscosity.H"
#include "laneDomains.H"
#include "UIndirectList.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- S, see above
template<int nDims, class Array>
[[gnu::always_inline]]
static inline Array largestSecondDerivative(const Array* F)
{
    Array C[nDims*nDims];
    volumeTerm::cofactors<nDims>(F, C);
    const Array excess =
        (volumeTerm::determinant<nDims>(F, C) - 1).abs();
    if (nDims == 2)
    {
        return F[0]*F[0] + F[1]*F[1] + F[2]*F[2] + F[3]*F[3] + excess;
    }
    Array squares(0), cofactorSquares(0);
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

template<class Array>
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
        to<Array>(current_, place) =
            at<Array>(from, place) + at<Array>(change, place);
    }
}


template<int nDims, class Array, Foam::fsi::dualStep step>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::volumes(copyBlock& block)
{
    const int n = nDims*nDims;
    const volumeTerm& term = shape_.elementTerm();
    const strainDomains& domains = term.volumeDomains();
    const scalar weight = shape_.admm().areaWeight;
    const scalar shearPart = term.shearPart();
    Array stretch = Array::Zero();

    forAll(volumeWeights_, domaini)
    {
        Array F[n], u[n];
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
                u[i] = at<Array>(dual_, n*domaini + i);
            }
            volumeTerm::toLocalStep<nDims>(F, u, weight, shearPart);
        }

        for (int i = 0; i < n; ++i)
        {
            const auto old = to<Array>(dual_, n*domaini + i);
            u[i] = volumeWeights_[domaini]*updateDual<step>(u[i], old);
        }
        spread<nDims>(domains, domaini, volumeRows_, u, block.residual);
    }
    to<Array>(stretch_, 0) = stretch;
}


template<int nDims, class Array, bool shear>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::addForces
(
    const scalar weight,
    copyBlock& block
)
{
    const shearMatrix& matrix = *shearForces_;
    const double* u = current_.cdata();
    for (label row = 0; row < matrix.size(); ++row)
    {
        Array f[nDims];
        matrix.force<nDims, shear>
        (
            row,
            [&](const label i, const label k) __attribute__((always_inline))
            {
                return at<Array>(u, nDims*i + k);
            },
            f
        );
        for (int k = 0; k < nDims; ++k)
        {
            to<Array>(block.residual, nDims*row + k) += weight*f[k];
        }
    }
}


template<int nDims, class Array, Foam::fsi::dualStep step>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::add(copyBlock& block)
{
    setCurrent<Array>(block.displacement, block.change);
    volumes<nDims, Array, step>(block);
    if (shearWeight_ > 0)
    {
        addForces<nDims, Array, true>(shearWeight_, block);
    }
    if (step != dualStep::start && viscousWeight_ > 0)
    {
        setCurrent<Array>(block.lessDrift, block.change);
        addForces<nDims, Array, false>(viscousWeight_, block);
    }
}


template<class Array>
[[gnu::always_inline]]
inline void Foam::fsi::elementForces::add
(
    const dualStep step,
    copyBlock& block
)
{
    withKnown
    (
        block.nDims,
        step,
        [&](const auto n, const auto known) __attribute__((always_inline))
        {
            add<n, Array, known>(block);
        }
    );
}


FSI_AVX512
void Foam::fsi::elementForces::addWide(const dualStep step, copyBlock& block)
{
    add<laneArray<8, 8>>(step, block);
}


FSI_AVX2_CLONES
void Foam::fsi::elementForces::addNarrow
(
    const int lanes,
    const dualStep step,
    copyBlock& block
)
{
    switch (lanes)
    {
        case 8: add<laneArray<8>>(step, block); break;
        case 4: add<laneArray<4>>(step, block); break;
        case 2: add<laneArray<2>>(step, block); break;
        default: add<laneArray<1>>(step, block);
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

    const scalar dt = factor.deltaT();
    volumeWeights_ =
        sqr(dt)*shape_.admm().areaWeight*term.stiffness()
       *term.volumeDomains().volumes();
    shearWeight_ = sqr(dt)*shape_.shearModulus();
    viscousWeight_ = dt*elementViscosity::boundRatio*shape_.viscosity();
    if (shearWeight_ > 0 || viscousWeight_ > 0)
    {
        shearForces_.reset(new shearMatrix(term.shearDomains(), rowOf));
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


void Foam::fsi::elementForces::add
(
    const int lanes,
    const dualStep step,
    copyBlock& block
)
{
    if (lanes == 8 && hasAVX512())
    {
        addWide(step, block);
    }
    else
    {
        addNarrow(lanes, step, block);
    }
}


// ************************************************************************* //
