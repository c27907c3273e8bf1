// SPDX-License-Identifier: GPL-3.0-or-later

#include "sharedResponse.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

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
    modes_.clear();
    for (const Eigen::MatrixXd& rotation : rotations)
    {
        modes_.push_back(multiply(rotation));
    }

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
