// SPDX-License-Identifier: GPL-3.0-or-later

#include "sharedResponse.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

std::vector<Eigen::MatrixXd> Foam::fsi::sharedResponse::multiplyModes
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


void Foam::fsi::sharedResponse::makeModes()
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::sharedResponse::sharedResponse(const bodyGroup& group)
:
    woodburyResponse(group)
{}


// ************************************************************************* //
