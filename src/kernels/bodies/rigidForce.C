// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidForce.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addRigidForce
(
    const bodyGroup& group,
    const Eigen::MatrixXd& boundaryForce,
    Eigen::MatrixXd& force
)
{
    const scalarField& nodeMasses = group.shape().nodeMasses();
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        nodeMasses.cdata(),
        nodeMasses.size()
    );
    const label nDims = group.shape().nDims();
    const auto rotations =
        group.response().modesOf(bodyResponse::modeKind::rotation);
    for (label first = 0; first < force.cols(); first += nDims)
    {
        const auto given = boundaryForce.middleCols(first, nDims);
        auto result = force.middleCols(first, nDims);
        const Eigen::RowVectorXd net(given.colwise().sum()/masses.sum());
        result += masses*net;
        for (const bodyResponse::mode* rotation : rotations)
        {
            const auto mode = rotation->values.middleCols(first, nDims);
            const scalar turn =
                mode.topRows(given.rows()).cwiseProduct(given).sum();
            result += turn*(masses.asDiagonal()*mode);
        }
    }
}


// ************************************************************************* //
