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

Foam::scalar Foam::fsi::viscousResponse::product
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b,
    const label copyi
) const
{
    const label nDims = group_.shape().nDims();
    return a.middleCols(nDims*copyi, nDims).cwiseProduct
    (
        b.middleCols(nDims*copyi, nDims)
    ).sum();
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
    prepare(links);
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
