// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseResponse.H"
#include "columnBasis.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::denseResponse::solveCopy
(
    const label copyi,
    const label first,
    const label nColumns,
    Eigen::MatrixXd& x
) const
{
    const denseCholesky& factor = factors_[copyi];
    const label n = factor.size();
    const label nRows = factor.nRows();
    columns_.resize(nRows*nColumns);
    for (label k = 0; k < nColumns; ++k)
    {
        double* column = columns_.data() + nRows*k;
        std::copy_n(x.col(first + k).data(), n, column);
        std::fill_n(column + n, nRows - n, 0.0);
    }
    factor.solve(nColumns, columns_.data());
    for (label k = 0; k < nColumns; ++k)
    {
        std::copy_n(columns_.data() + nRows*k, n, x.col(first + k).data());
    }
}


void Foam::fsi::denseResponse::factorCopy
(
    const label copyi,
    const std::vector<copyLink>& links
)
{
    denseCholesky& factor = factors_[copyi];
    factor.reset(panels_, 1/deltaT_);
    for (const copyLink& link : links)
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


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::denseResponse::makeModes()
{
    if (madeFor_ != deltaT_)
    {
        const label nB = group_.shape().nBoundaryNodes();
        Eigen::MatrixXd S
        (
            group_.shape().factor(deltaT_).boundaryInverse().llt()
           .solve(Eigen::MatrixXd::Identity(nB, nB))
        );
        S = (0.5*(S + S.transpose())).eval();
        boundary_ = densePanels(S);
        panels_.reset(S);
        madeFor_ = deltaT_;
    }
    woodburyResponse::makeModes();
}


void Foam::fsi::denseResponse::makeMatrices
(
    const std::vector<copyLink>* links,
    std::vector<Eigen::MatrixXd>& x
)
{
    columnBasis basis(x, group_.shape().nDims());
    factors_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        factorCopy(copyi, links[copyi]);
        const label first = basis.start(copyi);
        const label nColumns = basis.start(copyi + 1) - first;
        solveCopy(copyi, first, nColumns, basis.values());
    }
    basis.combine(x);
}


Eigen::MatrixXd Foam::fsi::denseResponse::multiply
(
    const Eigen::MatrixXd& x
) const
{
    Eigen::MatrixXd result;
    boundary_.multiply(x, result);
    return result;
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
        solveCopy(copyi, nDims*copyi, nDims, x);
    }
}


std::vector<Eigen::MatrixXd> Foam::fsi::denseResponse::multiplyModes
(
    std::vector<Eigen::MatrixXd>&& modes
) const
{
    columnBasis basis(modes, group_.shape().nDims());
    basis.values() = multiply(basis.values());
    basis.combine(modes);
    return std::move(modes);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::denseResponse::denseResponse(const bodyGroup& group)
:
    woodburyResponse(group)
{}


// ************************************************************************* //
