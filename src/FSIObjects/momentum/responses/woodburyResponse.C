// SPDX-License-Identifier: GPL-3.0-or-later

#include "woodburyResponse.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::woodburyResponse::woodburyResponse(const bodyGroup& group)
:
    viscousResponse(group)
{}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::woodburyResponse::solveMatrices
(
    std::vector<Eigen::MatrixXd>& x
) const
{
    for (Eigen::MatrixXd& each : x)
    {
        solveMatrices(Eigen::MatrixXd(each), each);
    }
}


Foam::fsi::woodburyResponse::modeVector Foam::fsi::woodburyResponse::project
(
    const std::vector<Eigen::MatrixXd>& modes,
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
        amount[mode] = modes[mode].middleCols(nDims*copyi, nDims)
           .cwiseProduct(columns).sum();
    }
    return amount;
}


std::vector<Eigen::MatrixXd> Foam::fsi::woodburyResponse::multiplyModes
(
    std::vector<Eigen::MatrixXd>&& modes
) const
{
    std::vector<Eigen::MatrixXd> products;
    for (const Eigen::MatrixXd& mode : modes)
    {
        products.push_back(multiply(mode));
    }
    return products;
}


void Foam::fsi::woodburyResponse::makeModes()
{
    const label nB = group_.shape().nBoundaryNodes();
    std::vector<Eigen::MatrixXd> rotations;
    scalarList signs;
    for (const bodyResponse::mode& mode : group_.response().modes())
    {
        if (mode.kind != bodyResponse::modeKind::volume)
        {
            rotations.emplace_back(mode.values.topRows(nB));
            signs.append(mode.sign);
        }
    }
    modes_ = multiplyModes(std::vector<Eigen::MatrixXd>(rotations));

    const label n(rotations.size());
    added_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        modeMatrix E(n, n);
        for (label mode = 0; mode < n; ++mode)
        {
            E.col(mode) = project(modes_, rotations[mode], copyi, n);
            E(mode, mode) += signs[mode];
        }
        added_[copyi] = -E.inverse();
    }
}


void Foam::fsi::woodburyResponse::updateLinks
(
    const std::vector<copyLink>* links,
    const std::vector<Eigen::MatrixXd>& resisting
)
{
    makeModes();
    for (const Eigen::MatrixXd& mode : resisting)
    {
        modes_.push_back(mode);
    }
    solved_ = modes_;
    makeMatrices(links, solved_);
    makeWoodbury();
    makeSource();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::woodburyResponse::addModes
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


void Foam::fsi::woodburyResponse::makeWoodbury()
{
    const label nModes(modes_.size());
    woodbury_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const label nAdded = added_[copyi].rows();
        modeMatrix inverse(modeMatrix::Identity(nModes, nModes));
        inverse.topLeftCorner(nAdded, nAdded) =
            deltaT_*added_[copyi].inverse();
        for (label mode = 0; mode < nModes; ++mode)
        {
            inverse.col(mode) += project(modes_, solved_[mode], copyi, nModes);
        }
        woodbury_[copyi] = inverse.inverse();
    }
}


void Foam::fsi::woodburyResponse::makeSource()
{
    const Eigen::MatrixXd predicted
    (
        start().topRows(group_.shape().nBoundaryNodes())
    );
    source_ = multiply(predicted);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const modeVector amount
        (
            added_[copyi]
           *project(modes_, predicted, copyi, added_[copyi].rows())
        );
        addModes(modes_, amount, copyi, source_);
    }
    source_ /= deltaT_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::woodburyResponse::solve
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    load_ = source_ + f;
    solveMatrices(load_, v);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const modeVector amount
        (
            -(
                woodbury_[copyi]
               *project(modes_, v, copyi, modes_.size())
            )
        );
        addModes(solved_, amount, copyi, v);
    }
}


// ************************************************************************* //
