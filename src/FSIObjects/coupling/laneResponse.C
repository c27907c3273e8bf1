// SPDX-License-Identifier: GPL-3.0-or-later

#include "laneResponse.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::laneResponse::laneResponse(const bodyGroup& group)
:
    viscousResponse(group)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::Vector2d Foam::fsi::laneResponse::project
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
        amount[mode] = turned_[mode].middleCols(nDims*copyi, nDims)
           .cwiseProduct(columns).sum();
    }
    return amount;
}


void Foam::fsi::laneResponse::makeModes()
{
    const bodyResponse& response = group_.response();
    const label nB = group_.shape().nBoundaryNodes();
    const Eigen::MatrixXd modes[2] =
    {
        response.rotationModes().topRows(nB),
        response.elasticRotation().topRows(nB)
    };
    for (label mode = 0; mode < 2; ++mode)
    {
        turned_[mode] = boundary().matrix()*modes[mode];
    }

    reduced_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        Eigen::Matrix2d E;
        E.col(0) = project(modes[0], copyi);
        E.col(1) = project(modes[1], copyi);
        E(0, 0) += 1;
        E(1, 1) -= 1;
        reduced_[copyi] = E.inverse();
    }
}


void Foam::fsi::laneResponse::factorBlock
(
    const label blocki,
    const copyLinks& links
)
{
    laneCholesky& block = factors_[blocki];
    block.reset(boundary(), 1/deltaT_);
    const label first = blocki*laneCholesky::lanes;
    const label last = min(first + laneCholesky::lanes, group_.size());
    for (label copyi = first; copyi < last; ++copyi)
    {
        for (const copyLink& link : links[copyi])
        {
            for (label i = 0; i < 3 && link.nodes[i] >= 0; ++i)
            {
                for (label j = 0; j <= i; ++j)
                {
                    block.add
                    (
                        int(copyi - first),
                        link.nodes[i],
                        link.nodes[j],
                        link.coefficient*link.weights[i]*link.weights[j]
                    );
                }
            }
        }
    }
    if (!block.factor())
    {
        FatalErrorInFunction
            << "The matrix of the viscous links of a copy of shape "
            << group_.shape().name() << ", " << first << " to " << last - 1
            << ", is not positive definite" << exit(FatalError);
    }
}


void Foam::fsi::laneResponse::solveBlocks
(
    const Eigen::MatrixXd& b,
    Eigen::MatrixXd& x
) const
{
    constexpr label lanes = laneCholesky::lanes;
    const label nDims = group_.shape().nDims();
    const labelList& rowOf = boundary().rowOf();
    const label n = b.rows();

    x.resize(n, b.cols());
    rows_.setSize(lanes*nDims*n);
    for (label blocki = 0; blocki < label(factors_.size()); ++blocki)
    {
        const label first = nDims*lanes*blocki;
        const label nColumns = min(nDims*lanes, label(b.cols()) - first);
        if (nColumns < nDims*lanes)
        {
            rows_ = 0;
        }
        for (label k = 0; k < nColumns; ++k)
        {
            const double* from = b.col(first + k).data();
            const label place = lanes*(k % nDims) + k/nDims;
            for (label i = 0; i < n; ++i)
            {
                rows_[lanes*nDims*rowOf[i] + place] = from[i];
            }
        }
        factors_[blocki].solve(rows_.data(), nDims);
        for (label k = 0; k < nColumns; ++k)
        {
            double* to = x.col(first + k).data();
            const label place = lanes*(k % nDims) + k/nDims;
            for (label i = 0; i < n; ++i)
            {
                to[i] = rows_[lanes*nDims*rowOf[i] + place];
            }
        }
    }
}


void Foam::fsi::laneResponse::makeWoodbury()
{
    solveBlocks(turned_[0], solved_[0]);
    solveBlocks(turned_[1], solved_[1]);
    woodbury_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        Eigen::Matrix2d inverse(deltaT_*reduced_[copyi].inverse());
        inverse.col(0) -= project(solved_[0], copyi);
        inverse.col(1) -= project(solved_[1], copyi);
        woodbury_[copyi] = inverse.inverse();
    }
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::laneResponse::prepare(const copyLinks& links)
{
    const label nDims = group_.shape().nDims();
    makeModes();
    factors_.resize
    (
        (group_.size() + laneCholesky::lanes - 1)/laneCholesky::lanes
    );
    for (label blocki = 0; blocki < label(factors_.size()); ++blocki)
    {
        factorBlock(blocki, links);
    }
    makeWoodbury();

    // K v~ = S v~ - Y E Y^T v~
    const Eigen::MatrixXd start(start_.topRows(boundary().size()));
    source_ = boundary().matrix()*start;
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const Eigen::Vector2d amount(reduced_[copyi]*project(start, copyi));
        for (label mode = 0; mode < 2; ++mode)
        {
            source_.middleCols(nDims*copyi, nDims) -=
                amount[mode]*turned_[mode].middleCols(nDims*copyi, nDims);
        }
    }
    source_ /= deltaT_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::laneResponse::solve
(
    Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    const label nDims = group_.shape().nDims();
    f += source_;
    solveBlocks(f, v);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const Eigen::Vector2d amount(woodbury_[copyi]*project(v, copyi));
        for (label mode = 0; mode < 2; ++mode)
        {
            v.middleCols(nDims*copyi, nDims) +=
                amount[mode]*solved_[mode].middleCols(nDims*copyi, nDims);
        }
    }
}


// ************************************************************************* //
