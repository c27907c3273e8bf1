// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroup.H"
#include "innerFlow.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::bodyGroup::predictMembrane
(
    const scalar dt,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (!response_.preparedFor(dt, positions_))
    {
        response_.prepare(dt, positions_, triangles_);
    }

    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape_.nodeMasses().cdata(),
        shape_.nNodes()
    );
    Eigen::MatrixXd total;
    internalForce(total);
    total += force;
    total += masses.asDiagonal()*velocities_/dt;
    response_.respondFreely(total, v);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::bodyGroup::innerDissipation(const label copyi) const
{
    if (!shape_.membrane())
    {
        return 0;
    }
    return innerFlow::dissipation
    (
        triangles_[copyi],
        positions_.middleCols(2*copyi, 2),
        velocities_.middleCols(2*copyi, 2),
        shape_.membrane()->innerViscosity*shape_.thickness()
    );
}


// ************************************************************************* //
