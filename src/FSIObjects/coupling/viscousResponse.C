// SPDX-License-Identifier: GPL-3.0-or-later

#include "laneResponse.H"
#include "sparseResponse.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::viscousResponse::viscousResponse(const bodyGroup& group)
:
    group_(group),
    deltaT_(0)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

std::unique_ptr<Foam::fsi::viscousResponse>
Foam::fsi::viscousResponse::New(const bodyGroup& group)
{
    if (group.response().matrix().coupled())
    {
        return std::make_unique<sparseResponse>(group);
    }
    return std::make_unique<laneResponse>(group);
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

Foam::fsi::viscousResponse::modeVector Foam::fsi::viscousResponse::project
(
    const Eigen::MatrixXd& x,
    const label copyi,
    const label nModes
) const
{
    const label nDims = group_.shape().nDims();
    const auto columns = x.middleCols(nDims*copyi, nDims);
    modeVector amount(nModes);
    for (label mode = 0; mode < nModes; ++mode)
    {
        amount[mode] = modes_[mode].middleCols(nDims*copyi, nDims)
           .cwiseProduct(columns).sum();
    }
    return amount;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousResponse::addModes
(
    const std::vector<Eigen::MatrixXd>& modes,
    const modeVector& amount,
    const label copyi,
    Eigen::MatrixXd& x
) const
{
    const label nDims = group_.shape().nDims();
    for (label mode = 0; mode < amount.size(); ++mode)
    {
        x.middleCols(nDims*copyi, nDims) +=
            amount[mode]*modes[mode].middleCols(nDims*copyi, nDims);
    }
}


void Foam::fsi::viscousResponse::makeWoodbury(const groupModes& transposed)
{
    const label nModes(modes_.size());
    solved_.resize(nModes);
    for (label mode = 0; mode < nModes; ++mode)
    {
        solveMatrices(modes_[mode], solved_[mode]);
    }
    woodbury_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        modeMatrix inverse(modeMatrix::Zero(nModes, nModes));
        inverse.topLeftCorner<2, 2>() = deltaT_*added_[copyi].inverse();
        for (label mode = 2; mode < nModes; ++mode)
        {
            inverse(mode, mode) = transposed[mode - 2].sign;
        }
        for (label mode = 0; mode < nModes; ++mode)
        {
            inverse.col(mode) += project(solved_[mode], copyi, nModes);
        }
        woodbury_[copyi] = inverse.inverse();
    }
}


void Foam::fsi::viscousResponse::makeSource()
{
    const Eigen::MatrixXd start(start_.topRows(modes_[0].rows()));
    source_ = multiply(start);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const modeVector amount(added_[copyi]*project(start, copyi, 2));
        addModes(modes_, amount, copyi, source_);
    }
    source_ /= deltaT_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousResponse::update
(
    const scalar dt,
    const std::vector<copyLink>* links,
    const groupModes& transposed,
    const Eigen::MatrixXd& predicted
)
{
    deltaT_ = dt;
    start_ = predicted;
    modes_.resize(2 + transposed.size());
    for (label mode = 2; mode < label(modes_.size()); ++mode)
    {
        const Eigen::MatrixXd& t = transposed[mode - 2].vectors;
        modes_[mode].setZero(nRows(), t.cols());
        modes_[mode].topRows(t.rows()) = t;
    }
    makeMatrices(links);
    makeWoodbury(transposed);
    makeSource();
}


void Foam::fsi::viscousResponse::solve
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    load_ = source_;
    load_.topRows(f.rows()) += f;
    solveMatrices(load_, solution_);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const modeVector amount
        (
            -(woodbury_[copyi]*project(solution_, copyi, modes_.size()))
        );
        addModes(solved_, amount, copyi, solution_);
    }
    v = solution_.topRows(f.rows());
}


void Foam::fsi::viscousResponse::finish
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    group_.respond(force, v);
    v += start_;
}


// ************************************************************************* //
