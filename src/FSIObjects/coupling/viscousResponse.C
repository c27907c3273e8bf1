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

Eigen::Vector2d Foam::fsi::viscousResponse::project
(
    const Eigen::MatrixXd& x,
    const label copyi
) const
{
    const label nDims = group_.shape().nDims();
    const auto columns = x.middleCols(nDims*copyi, nDims);
    Eigen::Vector2d amount;
    for (label mode = 0; mode < 2; ++mode)
    {
        amount[mode] = modes_[mode].middleCols(nDims*copyi, nDims)
           .cwiseProduct(columns).sum();
    }
    return amount;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousResponse::addModes
(
    const Eigen::MatrixXd (&modes)[2],
    const Eigen::Vector2d& amount,
    const label copyi,
    Eigen::MatrixXd& x
) const
{
    const label nDims = group_.shape().nDims();
    for (label mode = 0; mode < 2; ++mode)
    {
        x.middleCols(nDims*copyi, nDims) +=
            amount[mode]*modes[mode].middleCols(nDims*copyi, nDims);
    }
}


void Foam::fsi::viscousResponse::makeWoodbury()
{
    solveMatrices(modes_[0], solved_[0]);
    solveMatrices(modes_[1], solved_[1]);
    woodbury_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        Eigen::Matrix2d inverse(deltaT_*added_[copyi].inverse());
        inverse.col(0) += project(solved_[0], copyi);
        inverse.col(1) += project(solved_[1], copyi);
        woodbury_[copyi] = inverse.inverse();
    }
}


void Foam::fsi::viscousResponse::makeSource()
{
    const Eigen::MatrixXd start(start_.topRows(modes_[0].rows()));
    source_ = multiply(start);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const Eigen::Vector2d amount(added_[copyi]*project(start, copyi));
        addModes(modes_, amount, copyi, source_);
    }
    source_ /= deltaT_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousResponse::update
(
    const scalar dt,
    const copyLinks& links,
    const Eigen::MatrixXd& predicted
)
{
    deltaT_ = dt;
    start_ = predicted;
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
        const Eigen::Vector2d amount
        (
            -(woodbury_[copyi]*project(solution_, copyi))
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
