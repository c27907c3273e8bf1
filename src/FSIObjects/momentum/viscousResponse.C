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


void Foam::fsi::viscousResponse::makeWoodbury()
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
        const label nRotations = nModes - 2;
        inverse.bottomRightCorner(nRotations, nRotations).setIdentity();
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
    const std::vector<Eigen::MatrixXd>& rotations,
    const Eigen::MatrixXd& predicted
)
{
    deltaT_ = dt;
    start_ = predicted;
    modes_.resize(2);
    for (const Eigen::MatrixXd& rotation : rotations)
    {
        Eigen::MatrixXd mode(Eigen::MatrixXd::Zero(nRows(), rotation.cols()));
        mode.topRows(rotation.rows()) = rotation;
        modes_.push_back(mode);
    }
    makeMatrices(links);
    makeWoodbury();
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
