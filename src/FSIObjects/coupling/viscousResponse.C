// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousResponse.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::viscousResponse::viscousResponse(const bodyGroup& group)
:
    group_(group),
    deltaT_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::Vector3d Foam::fsi::viscousResponse::project
(
    const Eigen::MatrixXd& x,
    const label copyi
) const
{
    const label nDims = group_.shape().nDims();
    const auto columns = x.middleCols(nDims*copyi, nDims);
    Eigen::Vector3d amount;
    for (label mode = 0; mode < nModes; ++mode)
    {
        amount[mode] = turned_[mode].middleCols(nDims*copyi, nDims)
           .cwiseProduct(columns).sum();
    }
    return amount;
}


void Foam::fsi::viscousResponse::makeTurnDamping(const scalar viscosity)
{
    const label nDims = group_.shape().nDims();
    const label nB = group_.shape().nBoundaryNodes();
    const Eigen::MatrixXd r = group_.response().rotationModes().topRows(nB);

    // B v, see addTransposedForce()
    Eigen::MatrixXd& g = turned_[2];
    g.setZero(r.rows(), r.cols());
    for (const surfaceFace& face : group_.shape().faces())
    {
        for (label copyi = 0; copyi < group_.size(); ++copyi)
        {
            const label x = nDims*copyi, y = x + 1;
            const scalar fx = -0.5*viscosity*(r(face[1], y) - r(face[0], y));
            const scalar fy = 0.5*viscosity*(r(face[1], x) - r(face[0], x));
            for (label i = 0; i < 2; ++i)
            {
                g(face[i], x) += fx;
                g(face[i], y) += fy;
            }
        }
    }
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        auto gc = g.middleCols(nDims*copyi, nDims);
        const scalar damping =
            -gc.cwiseProduct(r.middleCols(nDims*copyi, nDims)).sum();
        gc /= std::sqrt(damping);
    }
}


void Foam::fsi::viscousResponse::makeModes()
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
        E.col(0) = project(modes[0], copyi).head<2>();
        E.col(1) = project(modes[1], copyi).head<2>();
        E(0, 0) += 1;
        E(1, 1) -= 1;
        reduced_[copyi].setZero();
        reduced_[copyi].topLeftCorner<2, 2>() = E.inverse();
        reduced_[copyi](2, 2) = -deltaT_;
    }
}


void Foam::fsi::viscousResponse::factorBlock
(
    const label blocki,
    const std::vector<std::vector<copyLink>>& links
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


void Foam::fsi::viscousResponse::solveBlocks
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


void Foam::fsi::viscousResponse::makeWoodbury()
{
    for (label mode = 0; mode < nModes; ++mode)
    {
        solveBlocks(turned_[mode], solved_[mode]);
    }
    woodbury_.resize(group_.size());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        Eigen::Matrix3d inverse(deltaT_*reduced_[copyi].inverse());
        for (label mode = 0; mode < nModes; ++mode)
        {
            inverse.col(mode) -= project(solved_[mode], copyi);
        }
        woodbury_[copyi] = inverse.inverse();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousResponse::update
(
    const scalar dt,
    const scalar viscosity,
    const std::vector<std::vector<copyLink>>& links,
    const Eigen::MatrixXd& predicted
)
{
    const label nDims = group_.shape().nDims();
    deltaT_ = dt;

    makeTurnDamping(viscosity);
    if (group_.shape().membrane())
    {
        dense_.resize(group_.size());
        source_.resize(turned_[2].rows(), turned_[2].cols());
        for (label copyi = 0; copyi < group_.size(); ++copyi)
        {
            updateMembrane(copyi, links[copyi], predicted);
        }
        return;
    }

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

    // K v~ = S v~ - Y E Y^T v~, and dt g (g.v^n)
    const Eigen::MatrixXd start(predicted.topRows(boundary().size()));
    const Eigen::MatrixXd old(group_.velocities().topRows(start.rows()));
    source_ = boundary().matrix()*start;
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        Eigen::Vector3d amount(reduced_[copyi]*project(start, copyi));
        amount[2] = -dt*project(old, copyi)[2];
        for (label mode = 0; mode < nModes; ++mode)
        {
            source_.middleCols(nDims*copyi, nDims) -=
                amount[mode]*turned_[mode].middleCols(nDims*copyi, nDims);
        }
    }
    source_ /= dt;
}


void Foam::fsi::viscousResponse::solve
(
    Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    const label nDims = group_.shape().nDims();
    f += source_;
    if (group_.shape().membrane())
    {
        solveMembranes(f, v);
        return;
    }
    solveBlocks(f, v);
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const Eigen::Vector3d amount(woodbury_[copyi]*project(v, copyi));
        for (label mode = 0; mode < nModes; ++mode)
        {
            v.middleCols(nDims*copyi, nDims) +=
                amount[mode]*solved_[mode].middleCols(nDims*copyi, nDims);
        }
    }
}


void Foam::fsi::viscousResponse::turnForce
(
    const Eigen::MatrixXd& v,
    Eigen::MatrixXd& f
) const
{
    const label nDims = group_.shape().nDims();
    const Eigen::MatrixXd change = v - group_.velocities().topRows(v.rows());
    f.resize(v.rows(), v.cols());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const auto g = turned_[2].middleCols(nDims*copyi, nDims);
        const scalar turn =
            g.cwiseProduct(change.middleCols(nDims*copyi, nDims)).sum();
        f.middleCols(nDims*copyi, nDims) = -turn*g;
    }
}


// ************************************************************************* //
