// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidBodies.H"
#include "rigidTurn.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::MatrixXd Foam::fsi::rigidBodies::lessMean
(
    const Eigen::Ref<const Eigen::MatrixXd>& values
) const
{
    const Eigen::RowVectorXd mean
    (
        masses_.transpose()*values/masses_.sum()
    );
    return values.rowwise() - mean;
}


Eigen::Matrix3d Foam::fsi::rigidBodies::moments
(
    const Eigen::MatrixXd& a,
    const Eigen::MatrixXd& b
) const
{
    const label nDims = shape().nDims();
    Eigen::Matrix3d sums(Eigen::Matrix3d::Zero());
    sums.topLeftCorner(nDims, nDims) = a.transpose()*masses_.asDiagonal()*b;
    return sums;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rigidBodies::rigidBodies(const shapeTemplate& shape)
:
    bodyGroup(shape),
    masses_
    (
        Eigen::Map<const Eigen::VectorXd>
        (
            shape.nodeMasses().cdata(), shape.nNodes()
        )
    ),
    arms_(shape.nNodes(), shape.nDims()),
    response_(shape)
{
    forAll(shape.points(), nodei)
    {
        for (label d = 0; d < shape.nDims(); ++d)
        {
            arms_(nodei, d) = shape.points()[nodei][d];
        }
    }
    arms_ = lessMean(arms_).eval();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::rigidBodies::predict
(
    const scalar,
    const scalar dt,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (!response_.preparedFor(dt, positions()))
    {
        response_.prepare(dt, positions());
    }
    response_.respond(masses_.asDiagonal()*velocities()/dt + force, v);
}


void Foam::fsi::rigidBodies::prepareResponse(const scalar dt)
{
    response_.prepare(dt, positions());
}


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

        const Eigen::Matrix3d spin(dt*moments(r, velocity));
        const Eigen::Vector3d momentum
        (
            spin(1, 2) - spin(2, 1),
            spin(2, 0) - spin(0, 2),
            spin(0, 1) - spin(1, 0)
        );
        Eigen::Matrix3d turn;
        if (!rigidTurn(moments(r, r), momentum, turn))
        {
            FatalErrorInFunction
                << "Object " << objectIds()[copyi] << " of the rigid shape "
                << shape().name() << " turns by about a radian or more in the"
                << " time step " << dt << " s. Take a smaller deltaT"
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
            )/dt;
        velocity.rowwise() += drift;
    }
}


// ************************************************************************* //
