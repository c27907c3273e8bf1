// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidForce.H"

#include <Eigen/Dense>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Add the rigid acceleration by forces on boundary nodes, times the weight of
//  each node
static void addWeighted
(
    const bodyGroup& group,
    const Eigen::Ref<const Eigen::VectorXd>& weights,
    const Eigen::MatrixXd& boundaryForce,
    Eigen::MatrixXd& sum
)
{
    const scalarField& masses = group.response().masses();
    const scalar mass =
        Eigen::Map<const Eigen::VectorXd>(masses.cdata(), masses.size()).sum();
    const label nDims = group.shape().nDims();
    const auto rotations =
        group.response().modesOf(bodyResponse::modeKind::rotation);
    for (label first = 0; first < sum.cols(); first += nDims)
    {
        const auto given = boundaryForce.middleCols(first, nDims);
        auto result = sum.middleCols(first, nDims);
        const Eigen::RowVectorXd net(given.colwise().sum()/mass);
        result += weights*net;
        for (const bodyResponse::mode* rotation : rotations)
        {
            const auto mode = rotation->values.middleCols(first, nDims);
            const scalar turn =
                mode.topRows(given.rows()).cwiseProduct(given).sum();
            result += turn*(weights.asDiagonal()*mode.topRows(sum.rows()));
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::addRigidForce
(
    const bodyGroup& group,
    const Eigen::MatrixXd& boundaryForce,
    Eigen::MatrixXd& force
)
{
    const scalarField& masses = group.response().masses();
    addWeighted
    (
        group,
        Eigen::Map<const Eigen::VectorXd>(masses.cdata(), masses.size()),
        boundaryForce,
        force
    );
}


void Foam::fsi::addSurfaceForce
(
    const bodyGroup& group,
    const Eigen::MatrixXd& boundaryForce,
    Eigen::MatrixXd& force
)
{
    const label nDims = group.shape().nDims();
    const Eigen::Index nB = boundaryForce.rows();
    const auto rotations =
        group.response().modesOf(bodyResponse::modeKind::rotation);
    const Eigen::VectorXd masses
    (
        Eigen::Map<const Eigen::VectorXd>
        (
            group.response().masses().cdata(), nB
        ).replicate(nDims, 1)
    );
    Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero
    (
        nDims*nB, nDims + Eigen::Index(rotations.size())
    );
    for (label d = 0; d < nDims; ++d)
    {
        rigid.block(d*nB, d, nB, 1).setOnes();
    }
    for (label first = 0; first < force.cols(); first += nDims)
    {
        Eigen::Index column = nDims;
        for (const bodyResponse::mode* rotation : rotations)
        {
            rigid.col(column++) =
                rotation->values.block(0, first, nB, nDims).reshaped();
        }
        const Eigen::MatrixXd momenta(masses.asDiagonal()*rigid);
        const Eigen::VectorXd acceleration
        (
            (rigid.transpose()*momenta).ldlt().solve
            (
                rigid.transpose()
               *boundaryForce.middleCols(first, nDims).reshaped()
            )
        );
        force.block(0, first, nB, nDims) +=
            (momenta*acceleration).reshaped(nB, nDims);
    }
}


void Foam::fsi::addRigidAcceleration
(
    const bodyGroup& group,
    const Eigen::MatrixXd& boundaryForce,
    Eigen::MatrixXd& acceleration
)
{
    addWeighted
    (
        group,
        Eigen::VectorXd::Ones(acceleration.rows()),
        boundaryForce,
        acceleration
    );
}


// ************************************************************************* //
