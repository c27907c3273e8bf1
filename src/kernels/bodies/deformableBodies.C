// SPDX-License-Identifier: GPL-3.0-or-later

#include "deformableBodies.H"
#include "matrixEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::deformableBodies::springLength
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


Foam::scalar Foam::fsi::deformableBodies::relaxedLength
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


Foam::scalar Foam::fsi::deformableBodies::addSprings
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


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::deformableBodies::resizeState(const label nCopies)
{
    if (shape().law().hasState())
    {
        springStates_.conservativeResize(shape().springs().size(), nCopies);
    }
}


void Foam::fsi::deformableBodies::startState(const label copyi)
{
    if (shape().law().hasState())
    {
        springStates_.col(copyi).setZero();
    }
}


void Foam::fsi::deformableBodies::exchangeState
(
    const label copyi,
    copyValues& values
)
{
    if (shape().law().hasState())
    {
        values.block(springStates_.col(copyi));
    }
}


void Foam::fsi::deformableBodies::writeState(Ostream& os) const
{
    if (shape().law().hasState())
    {
        writeMatrix(os, "springStates", springStates_);
    }
}


void Foam::fsi::deformableBodies::readState(const dictionary& dict)
{
    if (shape().law().hasState())
    {
        readMatrix(dict, "springStates", springStates_);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::deformableBodies::deformableBodies
(
    const shapeTemplate& shape,
    const bodyFreedom& freedom
)
:
    bodyGroup(shape, freedom),
    response_(shape, freedom)
{
    deformableBodies::resizeState(0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::deformableBodies::begin
(
    const scalar time,
    const scalar dt,
    const scalar ratio
)
{
    const springLaw& law = shape().law();
    if
    (
        shape().viscosity() > 0
     || law.hasState()
     || law.stiffnessRatio(dt) != 1
    )
    {
        FatalErrorInFunction
            << "Shape " << shape().name() << " has a viscosity (springs "
            << law.type() << "), whose rule is of first order in time: with it"
            << " ddtSchemes must be Euler. Of second order are the materials"
            << " rigid, membrane, and Hookean and neoHookean without viscosity"
            << exit(FatalError);
    }
    bodyGroup::begin(time, dt, ratio);
}


void Foam::fsi::deformableBodies::constrain
(
    const scalar dt,
    Eigen::MatrixXd& v
) const
{
    response_.constrainVolume(dt, start(), v);
}


void Foam::fsi::deformableBodies::move
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


void Foam::fsi::deformableBodies::internalForce(Eigen::MatrixXd& force) const
{
    force.setZero(positions().rows(), positions().cols());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        addSprings(copyi, &force);
        addTerms(copyi, &force);
    }
}


Foam::scalar Foam::fsi::deformableBodies::elasticEnergy() const
{
    scalar energy = 0;
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        energy += addSprings(copyi, nullptr) + addTerms(copyi, nullptr);
    }
    return energy;
}


// ************************************************************************* //
