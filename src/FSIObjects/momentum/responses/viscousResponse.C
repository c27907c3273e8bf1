// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseResponse.H"
#include "laneResponse.H"
#include "modalResponse.H"

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
    if (!group.response().hasMatrix())
    {
        return std::make_unique<modalResponse>(group);
    }
    if (group.shape().nDims() == 3)
    {
        return std::make_unique<denseResponse>(group);
    }
    return std::make_unique<laneResponse>(group);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::viscousResponse::update
(
    const scalar dt,
    const std::vector<copyLink>* links,
    const std::vector<Eigen::MatrixXd>& resisting,
    const Eigen::MatrixXd& predicted
)
{
    deltaT_ = dt;
    start_ = predicted;
    updateLinks(links, resisting);
}


void Foam::fsi::viscousResponse::finish
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    group_.response().respond(force, v);
    v += start_;
}


// ************************************************************************* //
