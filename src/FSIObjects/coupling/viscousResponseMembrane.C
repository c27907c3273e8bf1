// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousResponse.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The first rows of a copy's columns, x of all nodes and then y
static Eigen::VectorXd stacked
(
    const Eigen::MatrixXd& columns,
    const label nRows,
    const label copyi
)
{
    Eigen::VectorXd result(2*nRows);
    result << columns.col(2*copyi).head(nRows),
        columns.col(2*copyi + 1).head(nRows);
    return result;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousResponse::updateMembrane
(
    const label copyi,
    const std::vector<copyLink>& links,
    const Eigen::MatrixXd& predicted
)
{
    const bodyResponse& response = group_.response();
    const label n = group_.shape().nBoundaryNodes();
    const Eigen::VectorXd r = stacked(response.rotationModes(), n, copyi);
    const Eigen::VectorXd q = stacked(response.elasticRotation(), n, copyi);
    const Eigen::VectorXd g = stacked(turned_[2], n, copyi);

    Eigen::MatrixXd matrix = response.matrix().boundaryInverse(copyi);
    matrix += r*r.transpose() - q*q.transpose();
    matrix = matrix.llt().solve
    (
        Eigen::MatrixXd::Identity(2*n, 2*n)
    ).eval()/deltaT_;

    const Eigen::VectorXd source =
        matrix*stacked(predicted, n, copyi)
      + g*g.dot(stacked(group_.velocities(), n, copyi));
    source_.col(2*copyi) = source.head(n);
    source_.col(2*copyi + 1) = source.tail(n);

    matrix += g*g.transpose();
    for (const copyLink& link : links)
    {
        for (label i = 0; i < 2; ++i)
        {
            for (label j = 0; j < 2; ++j)
            {
                const scalar w =
                    link.coefficient*link.weights[i]*link.weights[j];
                matrix(link.nodes[i], link.nodes[j]) += w;
                matrix(n + link.nodes[i], n + link.nodes[j]) += w;
            }
        }
    }
    dense_[copyi].compute(matrix);
}


void Foam::fsi::viscousResponse::solveMembranes
(
    const Eigen::MatrixXd& f,
    Eigen::MatrixXd& v
) const
{
    v.resize(f.rows(), f.cols());
    for (label copyi = 0; copyi < group_.size(); ++copyi)
    {
        const Eigen::VectorXd x =
            dense_[copyi].solve(stacked(f, f.rows(), copyi));
        v.col(2*copyi) = x.head(f.rows());
        v.col(2*copyi + 1) = x.tail(f.rows());
    }
}


// ************************************************************************* //
