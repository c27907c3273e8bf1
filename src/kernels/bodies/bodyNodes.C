// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyNodes.H"
#include "backwardStep.H"
#include "matrixEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyNodes::bodyNodes()
:
    history_(false),
    deltaT_(0),
    ratio_(0)
{}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::bodyNodes::resizeNodes
(
    const label nNodes,
    const label nColumns
)
{
    positions_.conservativeResize(nNodes, nColumns);
    velocities_.conservativeResize(nNodes, nColumns);
    if (history_)
    {
        lastMean_.conservativeResize(nNodes, nColumns);
        lastVelocities_.conservativeResize(nNodes, nColumns);
    }
}


void Foam::fsi::bodyNodes::startNodes
(
    const label firstColumn,
    const label nColumns
)
{
    if (history_)
    {
        const auto v = velocities_.middleCols(firstColumn, nColumns);
        lastMean_.middleCols(firstColumn, nColumns) = v;
        lastVelocities_.middleCols(firstColumn, nColumns) = v;
    }
}


void Foam::fsi::bodyNodes::exchangeNodes
(
    const label firstColumn,
    const label nColumns,
    copyValues& values
)
{
    values.block(positions_.middleCols(firstColumn, nColumns));
    values.block(velocities_.middleCols(firstColumn, nColumns));
    if (history_)
    {
        values.block(lastMean_.middleCols(firstColumn, nColumns));
        values.block(lastVelocities_.middleCols(firstColumn, nColumns));
    }
}


void Foam::fsi::bodyNodes::writeNodes(Ostream& os) const
{
    writeMatrix(os, "positions", positions_);
    writeMatrix(os, "velocities", velocities_);
    if (history_)
    {
        writeMatrix(os, "lastMean", lastMean_);
        writeMatrix(os, "lastVelocities", lastVelocities_);
    }
}


void Foam::fsi::bodyNodes::readNodes(const dictionary& dict)
{
    readMatrix(dict, "positions", positions_);
    readMatrix(dict, "velocities", velocities_);
    history_ = dict.found("lastMean") || dict.found("lastVelocities");
    if (history_)
    {
        lastMean_ = velocities_;
        lastVelocities_ = velocities_;
        readMatrix(dict, "lastMean", lastMean_);
        readMatrix(dict, "lastVelocities", lastVelocities_);
    }
}


void Foam::fsi::bodyNodes::finishNodes
(
    const scalar tau,
    const Eigen::MatrixXd& v
)
{
    if (!secondOrder())
    {
        positions_ += tau*v;
        velocities_ = v;
        return;
    }
    positions_ = start_ + tau*v;
    velocities_ = v;
    lastMean_ = (positions_ - oldPositions_)/deltaT_;
    lastVelocities_ = oldVelocities_;
    deltaT_ = 0;
}


Eigen::MatrixXd Foam::fsi::bodyNodes::lastPositions() const
{
    return
        ratio_ > 0
      ? (oldPositions_ - (deltaT_/ratio_)*lastMean_).eval()
      : oldPositions_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyNodes::begin
(
    const scalar,
    const scalar dt,
    const scalar ratio
)
{
    deltaT_ = dt;
    ratio_ = ratio;
    if (!history_)
    {
        history_ = true;
        lastMean_ = velocities_;
        lastVelocities_ = velocities_;
    }
    oldPositions_ = positions_;
    oldVelocities_ = velocities_;

    // x^n - x^{n-1} = dt0 lastMean, dt0 = dt/r
    const backwardStep step{ratio};
    const scalar dt0 = ratio > 0 ? dt/ratio : 0;
    start_ = positions_ + step.share()*dt0*lastMean_;
    startVelocities_ =
        velocities_ + step.share()*(velocities_ - lastVelocities_);
    positions_ += dt*velocities_;
}


void Foam::fsi::bodyNodes::jump
(
    const scalar part,
    const Eigen::MatrixXd& dv
)
{
    lastMean_ += (1 - part)*dv;
    lastVelocities_ += dv;
}


Eigen::MatrixXd Foam::fsi::bodyNodes::standstill(const scalar tau) const
{
    if (!secondOrder())
    {
        return Eigen::MatrixXd::Zero(positions_.rows(), positions_.cols());
    }
    return (oldPositions_ - start_)/tau;
}


// ************************************************************************* //
