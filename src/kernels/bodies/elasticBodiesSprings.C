// SPDX-License-Identifier: GPL-3.0-or-later

#include "elasticBodies.H"
#include "elementEnergy.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::elasticBodies::springLength
(
    const label springi,
    const label copyi
) const
{
    const edge& ends = shape().springs()[springi];
    const auto x = ofCopy(positions(), copyi);
    scalar squares = 0;
    for (label i = 0; i < shape().nDims(); ++i)
    {
        squares += sqr(x(ends[1], i) - x(ends[0], i));
    }
    return std::sqrt(squares);
}


Foam::scalar Foam::fsi::elasticBodies::relaxedLength
(
    const label springi,
    const label copyi
) const
{
    return shape().law().relaxedLength
    (
        shape().restLengths()[springi],
        springStates_.size() ? springStates_(springi, copyi) : 0
    );
}


Foam::scalar Foam::fsi::elasticBodies::addSprings
(
    const label copyi,
    Eigen::MatrixXd* force
) const
{
    const auto x = ofCopy(positions(), copyi);
    const label nDims = shape().nDims();
    scalar energy = 0;
    forAll(shape().springs(), springi)
    {
        const scalar relaxed = relaxedLength(springi, copyi);
        const scalar length = springLength(springi, copyi);
        const scalar stiffness = shape().springConstants()[springi];
        energy += 0.5*stiffness*sqr(length - relaxed);
        if (force)
        {
            const edge& ends = shape().springs()[springi];
            auto f = ofCopy(*force, copyi);
            const scalar pull = stiffness*(1 - relaxed/length);
            for (label i = 0; i < nDims; ++i)
            {
                const scalar part =
                    pull*(x(ends[1], i) - x(ends[0], i));
                f(ends[0], i) += part;
                f(ends[1], i) -= part;
            }
        }
    }
    return energy;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::elasticBodies::move
(
    const scalar dt,
    const Eigen::MatrixXd& v
)
{
    bodyGroup::move(dt, v);
    if (!shape().law().hasState())
    {
        return;
    }
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        forAll(shape().springs(), springi)
        {
            scalar& state = springStates_(springi, copyi);
            state = shape().law().advanceState
            (
                shape().restLengths()[springi],
                springLength(springi, copyi),
                state,
                dt
            );
        }
    }
}


void Foam::fsi::elasticBodies::internalForce(Eigen::MatrixXd& force) const
{
    force.setZero(positions().rows(), positions().cols());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        addSprings(copyi, &force);
        addElementEnergy(shape(), positions(), copyi, &force);
    }
}


Foam::scalar Foam::fsi::elasticBodies::elasticEnergy() const
{
    scalar energy = 0;
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        energy +=
            addSprings(copyi, nullptr)
          + addElementEnergy(shape(), positions(), copyi, nullptr);
    }
    return energy;
}


// ************************************************************************* //
