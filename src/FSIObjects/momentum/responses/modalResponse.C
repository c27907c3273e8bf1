// SPDX-License-Identifier: GPL-3.0-or-later

#include "modalResponse.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::modalResponse::modalResponse(const bodyGroup& group)
:
    viscousResponse(group)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::VectorXd Foam::fsi::modalResponse::ofCopy
(
    const Eigen::MatrixXd& values,
    const label copyi
) const
{
    const label nDims = group_.shape().nDims();
    const label nB = group_.shape().nBoundaryNodes();
    Eigen::VectorXd result(nDims*nB);
    for (label d = 0; d < nDims; ++d)
    {
        result.segment(d*nB, nB) = values.col(nDims*copyi + d).head(nB);
    }
    return result;
}


void Foam::fsi::modalResponse::setCopy
(
    const label copyi,
    const std::vector<copyLink>& links,
    const std::vector<Eigen::MatrixXd>& resisting
)
{
    const label nDims = group_.shape().nDims();
    const label nB = group_.shape().nBoundaryNodes();
    const auto& modes = group_.response().modes();
    const label nModes(modes.size());
    copyData& copy = copies_[copyi];

    // The modes, and behind them v~
    Eigen::MatrixXd all(nDims*nB, nModes + 1);
    for (label k = 0; k < nModes; ++k)
    {
        all.col(k) = ofCopy(modes[k].values, copyi);
    }
    all.col(nModes) = ofCopy(start(), copyi);
    copy.modes = all.leftCols(nModes);

    // Their products with W + T T^T
    Eigen::MatrixXd products(Eigen::MatrixXd::Zero(nModes, nModes + 1));
    Eigen::RowVectorXd atLink(nModes + 1);
    for (const copyLink& link : links)
    {
        const label n = link.nNodes();
        for (label d = 0; d < nDims; ++d)
        {
            atLink.setZero();
            for (label i = 0; i < n; ++i)
            {
                atLink += link.weights[i]*all.row(d*nB + link.nodes[i]);
            }
            products +=
                link.coefficient*atLink.head(nModes).transpose()*atLink;
        }
    }
    for (const Eigen::MatrixXd& mode : resisting)
    {
        const Eigen::RowVectorXd along(ofCopy(mode, copyi).transpose()*all);
        products += along.head(nModes).transpose()*along;
    }

    copy.load = -products.col(nModes);
    copy.inverse =
    (
        Eigen::MatrixXd::Identity(nModes, nModes)/deltaT_
      + products.leftCols(nModes)
    ).inverse();
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::modalResponse::updateLinks
(
    const std::vector<copyLink>* links,
    const std::vector<Eigen::MatrixXd>& resisting
)
{
    copies_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        setCopy(copyi, links[copyi], resisting);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::modalResponse::solve
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    const label nDims = group_.shape().nDims();
    const label nB = f.rows();
    v = start().topRows(nB);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const copyData& copy = copies_[copyi];
        const Eigen::VectorXd amounts
        (
            copy.inverse
           *(copy.modes.transpose()*ofCopy(f, copyi) + copy.load)
        );
        const Eigen::VectorXd change(copy.modes*amounts);
        for (label d = 0; d < nDims; ++d)
        {
            v.col(nDims*copyi + d) += change.segment(d*nB, nB);
        }
    }
}


// ************************************************************************* //
