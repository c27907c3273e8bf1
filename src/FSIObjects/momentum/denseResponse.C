// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseResponse.H"

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::denseResponse::makeModes()
{
    if (madeFor_ != deltaT_)
    {
        const label nB = nRows();
        boundary_ = group_.shape().factor(deltaT_).boundaryInverse().llt()
           .solve(Eigen::MatrixXd::Identity(nB, nB));
        boundary_ = (0.5*(boundary_ + boundary_.transpose())).eval();
        panels_.reset(boundary_);
        madeFor_ = deltaT_;
    }
    sharedResponse::makeModes();
}


void Foam::fsi::denseResponse::makeMatrices
(
    const std::vector<copyLink>* links
)
{
    factors_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        denseCholesky& factor = factors_[copyi];
        factor.reset(panels_, 1/deltaT_);
        for (const copyLink& link : links[copyi])
        {
            const label n = link.nNodes();
            for (label i = 0; i < n; ++i)
            {
                for (label j = 0; j <= i; ++j)
                {
                    factor.add
                    (
                        link.nodes[i],
                        link.nodes[j],
                        link.coefficient*link.weights[i]*link.weights[j]
                    );
                }
            }
        }
        if (!factor.factor())
        {
            FatalErrorInFunction
                << "The matrix of the viscous links of copy " << copyi
                << " of shape " << group_.shape().name()
                << " is not positive definite" << exit(FatalError);
        }
    }
}


void Foam::fsi::denseResponse::solveMatrices
(
    const Eigen::MatrixXd& b,
    Eigen::MatrixXd& x
) const
{
    const label nDims = group_.shape().nDims();
    x = b;
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        factors_[copyi].solve(x.middleCols(nDims*copyi, nDims), columns_);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::denseResponse::denseResponse(const bodyGroup& group)
:
    sharedResponse(group)
{}


// ************************************************************************* //
