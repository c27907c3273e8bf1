// SPDX-License-Identifier: GPL-3.0-or-later

#include "springForces.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int lanes>
void Foam::fsi::springForces::setRestLengths
(
    const copyBlock& block,
    const Eigen::MatrixXd& states,
    const label copyi
)
{
    typedef laneArray<lanes> array;
    const springLaw& law = shape_.law();
    const label nDims = block.nDims;
    array state = array::Zero();

    forAll(weights_, springi)
    {
        const label a = nDims*rows_[2*springi];
        const label b = nDims*rows_[2*springi + 1];
        array squares = array::Zero();
        for (label i = 0; i < nDims; ++i)
        {
            const array d =
                at<lanes>(block.start, b + i) - at<lanes>(block.start, a + i);
            squares += d*d;
        }
        const array length = squares.sqrt();

        if (law.hasState())
        {
            for (int lane = 0; lane < lanes; ++lane)
            {
                state[lane] = states(springi, copyi + lane);
            }
        }
        law.restLengths
        (
            lanes,
            shape_.restLengths()[springi],
            length.data(),
            state.data(),
            block.deltaT,
            restLengths_.data() + lanes*springi
        );
    }
}


template<int nDims, class Array, Foam::fsi::dualStep step>
[[gnu::always_inline]]
inline void Foam::fsi::springForces::add(copyBlock& block)
{
    forAll(weights_, springi)
    {
        const label a = nDims*rows_[2*springi];
        const label b = nDims*rows_[2*springi + 1];

        // y, which is D x at the start
        Array y[nDims], squares;
        for (int i = 0; i < nDims; ++i)
        {
            y[i] =
                (at<Array>(block.start, b + i) - at<Array>(block.start, a + i))
              + (
                    at<Array>(block.change, b + i)
                  - at<Array>(block.change, a + i)
                );
            if (step == dualStep::local)
            {
                y[i] += at<Array>(dual_, nDims*springi + i);
            }
            squares = i ? squares + y[i]*y[i] : y[i]*y[i];
        }

        // u over y
        const Array length = squares.sqrt().max(VSMALL);
        const Array fromRest =
            (1 - at<Array>(restLengths_, springi)/length)
           *(step == dualStep::local ? fraction_ : ratio_);

        const scalar weight = weights_[springi];
        for (int i = 0; i < nDims; ++i)
        {
            const auto u = to<Array>(dual_, nDims*springi + i);
            const Array g = updateDual<step>(fromRest*y[i], u);
            to<Array>(block.residual, a + i) -= weight*g;
            to<Array>(block.residual, b + i) += weight*g;
        }
    }
}


template<class Array>
[[gnu::always_inline]]
inline void Foam::fsi::springForces::add
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::springForces::springForces(const shapeTemplate& shape)
:
    shape_(shape)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::springForces::setFactor(const admmFactor& factor)
{
    const labelList& rowOf = factor.rowOf();
    rows_.resize(2*shape_.springs().size());
    forAll(shape_.springs(), springi)
    {
        const edge& ends = shape_.springs()[springi];
        rows_[2*springi] = rowOf[ends[0]];
        rows_[2*springi + 1] = rowOf[ends[1]];
    }

    const scalar dt = factor.deltaT();
    weights_ = sqr(dt)*shape_.springWeights(dt);
    if (shape_.shearModulus() > 0)
    {
        weights_.clear();
    }
    ratio_ = 1/shape_.admm().springWeight;
    fraction_ = 1/(1 + shape_.admm().springWeight);
}


void Foam::fsi::springForces::resize(const label lanes)
{
    const label n = lanes*weights_.size();
    if (restLengths_.size() < n)
    {
        restLengths_.resize(n);
        dual_.resize(shape_.nDims()*n);
    }
}


void Foam::fsi::springForces::start
(
    const int lanes,
    const copyBlock& block,
    const Eigen::MatrixXd& states,
    const label copyi
)
{
    switch (lanes)
    {
        case 8: setRestLengths<8>(block, states, copyi); break;
        case 4: setRestLengths<4>(block, states, copyi); break;
        case 2: setRestLengths<2>(block, states, copyi); break;
        default: setRestLengths<1>(block, states, copyi);
    }
}


FSI_AVX2_CLONES
void Foam::fsi::springForces::add
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


// ************************************************************************* //
