// SPDX-License-Identifier: GPL-3.0-or-later

#include "elasticBodies.H"
#include "elementEnergy.H"
#include "elementViscosity.H"
#include "matrixEntry.H"
#include "rigidForce.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

Foam::scalar Foam::fsi::elasticBodies::addTerms
(
    const label copyi,
    Eigen::MatrixXd* force
) const
{
    return addElementEnergy(shape(), positions(), copyi, force);
}


void Foam::fsi::elasticBodies::resizeState(const label nCopies)
{
    deformableBodies::resizeState(nCopies);
    const label nRows = shape().nBoundaryNodes();
    meanLoad_.conservativeResize(nRows, shape().nDims()*nCopies);
    lastLoad_.conservativeResize(nRows, shape().nDims()*nCopies);
}


void Foam::fsi::elasticBodies::startState(const label copyi)
{
    deformableBodies::startState(copyi);
    ofCopy(meanLoad_, copyi).setZero();
    ofCopy(lastLoad_, copyi).setZero();
}


void Foam::fsi::elasticBodies::exchangeState
(
    const label copyi,
    copyValues& values
)
{
    deformableBodies::exchangeState(copyi, values);
    values.block(ofCopy(meanLoad_, copyi));
    values.block(ofCopy(lastLoad_, copyi));
}


void Foam::fsi::elasticBodies::writeState(Ostream& os) const
{
    writeMatrix(os, "meanLoad", meanLoad_);
    writeMatrix(os, "lastLoad", lastLoad_);
    deformableBodies::writeState(os);
}


void Foam::fsi::elasticBodies::readState(const dictionary& dict)
{
    readMatrix(dict, "meanLoad", meanLoad_);
    readMatrix(dict, "lastLoad", lastLoad_);
    deformableBodies::readState(dict);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::elasticBodies::elasticBodies
(
    const shapeTemplate& shape,
    const bodyFreedom& freedom
)
:
    deformableBodies(shape, freedom),
    meanLoad_(shape.nBoundaryNodes(), 0),
    lastLoad_(shape.nBoundaryNodes(), 0),
    solver_(shape)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    const scalar,
    const scalar dt,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
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
            springStates(), secondOrder(),
            shape().held().empty() ? nullptr : &anchors()
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


// ************************************************************************* //
