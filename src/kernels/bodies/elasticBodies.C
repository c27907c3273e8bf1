// SPDX-License-Identifier: GPL-3.0-or-later

#include "elasticBodies.H"
#include "elementViscosity.H"
#include "matrixEntry.H"
#include "rigidForce.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::elasticBodies::resizeState(const label nCopies)
{
    const label nRows = shape().nBoundaryNodes();
    meanLoad_.conservativeResize(nRows, shape().nDims()*nCopies);
    lastLoad_.conservativeResize(nRows, shape().nDims()*nCopies);
    if (shape().law().hasState())
    {
        springStates_.conservativeResize(shape().springs().size(), nCopies);
    }
}


void Foam::fsi::elasticBodies::startState(const label copyi)
{
    ofCopy(meanLoad_, copyi).setZero();
    ofCopy(lastLoad_, copyi).setZero();
    if (shape().law().hasState())
    {
        springStates_.col(copyi).setZero();
    }
}


void Foam::fsi::elasticBodies::exchangeState
(
    const label copyi,
    copyValues& values
)
{
    if (shape().law().hasState())
    {
        values.block(springStates_.col(copyi));
    }
    values.block(ofCopy(meanLoad_, copyi));
    values.block(ofCopy(lastLoad_, copyi));
}


void Foam::fsi::elasticBodies::writeState(Ostream& os) const
{
    writeMatrix(os, "meanLoad", meanLoad_);
    writeMatrix(os, "lastLoad", lastLoad_);
    if (shape().law().hasState())
    {
        writeMatrix(os, "springStates", springStates_);
    }
}


void Foam::fsi::elasticBodies::readState(const dictionary& dict)
{
    readMatrix(dict, "meanLoad", meanLoad_);
    readMatrix(dict, "lastLoad", lastLoad_);
    if (shape().law().hasState())
    {
        readMatrix(dict, "springStates", springStates_);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::elasticBodies::elasticBodies
(
    const shapeTemplate& shape,
    const bodyFreedom& freedom
)
:
    bodyGroup(shape, freedom),
    response_(shape, freedom),
    solver_(shape)
{
    elasticBodies::resizeState(0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::elasticBodies::begin
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
            << " rigid, and Hookean and neoHookean without viscosity"
            << exit(FatalError);
    }
    bodyGroup::begin(time, dt, ratio);
}


Eigen::MatrixXd Foam::fsi::elasticBodies::splitLoad(Eigen::MatrixXd& load)
{
    // A quarter: stable where the response is up to 8 times as stiff
    meanLoad_ += 0.25*(lastLoad_ - meanLoad_);

    Eigen::MatrixXd turning = Eigen::MatrixXd::Zero(load.rows(), load.cols());
    addRigidForce(*this, meanLoad_, turning);
    Eigen::MatrixXd rest(load + turning);
    rest.topRows(meanLoad_.rows()) -= meanLoad_;
    load -= rest;
    return rest;
}


void Foam::fsi::elasticBodies::keepLoad(const Eigen::MatrixXd& load)
{
    lastLoad_ = load.topRows(lastLoad_.rows());
}


void Foam::fsi::elasticBodies::expectLoad(const Eigen::MatrixXd& load)
{
    meanLoad_ += load;
    lastLoad_ += load;
}


void Foam::fsi::elasticBodies::predict
(
    const scalar time,
    const scalar dt,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    const Eigen::MatrixXd places(heldPlaces(time, dt));
    const labelRange copies(0, size());
    const bool viscous = shape().viscosity() > 0;
    Eigen::MatrixXd total;
    if (viscous)
    {
        total = force;
        elementViscosity::addForce
        (
            shape(),
            positions(),
            velocities(),
            copies,
            total
        );
    }
    solver_.solve
    (
        dt,
        {
            start(), startVelocities(), viscous ? total : force,
            springStates_, secondOrder(),
            shape().held().empty() ? nullptr : &places
        },
        copies,
        v
    );
    if (!freedom().movesFreely() || !freedom().turnsFreely())
    {
        if (!response_.preparedFor(dt, positions()))
        {
            response_.prepare(dt, positions());
        }
        response_.hold(v);
    }
}


void Foam::fsi::elasticBodies::prepareResponse(const scalar dt)
{
    response_.prepare(dt, positions());
}


void Foam::fsi::elasticBodies::constrain
(
    const scalar dt,
    Eigen::MatrixXd& v
) const
{
    response_.constrainVolume(dt, start(), v);
}


// ************************************************************************* //
