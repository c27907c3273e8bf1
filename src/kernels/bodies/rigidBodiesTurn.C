// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidBodies.H"
#include "rigidTurn.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fsi::rigidBodies::turnBy
(
    const Eigen::Matrix3d& S,
    const Eigen::Vector3d& L,
    Eigen::Matrix3d& turnLess1
) const
{
    if (freedom().turnsFreely())
    {
        return rigidTurn(S, L, turnLess1);
    }
    // About one axis L is the moment of inertia times the sine of the angle
    Eigen::Vector3d angles(angularVelocityBy(S, L));
    for (label i = 0; i < 3; ++i)
    {
        if (!(mag(angles[i]) < 0.9))
        {
            return false;
        }
        angles[i] = std::asin(angles[i]);
    }
    turnLess1 = exponentialLess1(angles);
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::rigidBodies::constrain
(
    const scalar dt,
    Eigen::MatrixXd& v
) const
{
    const label nDims = shape().nDims();
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        const Eigen::MatrixXd r(lessMean(ofCopy(positions(), copyi)));
        auto velocity = ofCopy(v, copyi);
        const Eigen::RowVectorXd drift
        (
            masses_.transpose()*velocity/masses_.sum()
        );

        // Where a step of second order starts from, less r
        const Eigen::MatrixXd before
        (
            secondOrder()
          ? (lessMean(ofCopy(start(), copyi)) - r).eval()
          : Eigen::MatrixXd::Zero(r.rows(), r.cols()).eval()
        );
        const Eigen::Vector3d momentum
        (
            axialVector(dt*moments(r, velocity) + moments(r, before))
        );
        Eigen::Matrix3d turn;
        if (!turnBy(moments(r, r), momentum, turn))
        {
            FatalErrorInFunction
                << "Object " << objectIds()[copyi] << " of the rigid shape "
                << shape().name() << " turns by about a radian or more in the"
                << " time step " << dt << " s. Take a smaller deltaT. If bodies"
                << " or walls squeeze it, there is no room for it"
                << exit(FatalError);
        }

        // The body's axes from the positions: the polar factor of r X^T. What
        // is not rigid in the positions has no momentum and no spin then
        Eigen::Matrix3d image(moments(r, arms_));
        image(2, 2) += nDims == 2 ? image.trace() : 0;
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd
        (
            image, Eigen::ComputeFullU | Eigen::ComputeFullV
        );
        const Eigen::Matrix3d axes(svd.matrixU()*svd.matrixV().transpose());
        const Eigen::MatrixXd roundOff
        (
            lessMean
            (
                arms_*axes.topLeftCorner(nDims, nDims).transpose() - r
            )
        );
        velocity =
            (
                r*turn.topLeftCorner(nDims, nDims).transpose() + roundOff
              - before
            )/dt;
        velocity.rowwise() += drift;
    }
}


// ************************************************************************* //
