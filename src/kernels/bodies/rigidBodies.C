// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidBodies.H"
#include "backwardStep.H"
#include "rigidTurn.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::MatrixXd Foam::fsi::rigidBodies::lessMean
(
    const Eigen::Ref<const Eigen::MatrixXd>& values
) const
{
    // Twice: far from the origin the first mean is rounded
    Eigen::MatrixXd result(values);
    for (label i = 0; i < 2; ++i)
    {
        result.rowwise() -= mean(result);
    }
    return result;
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


Eigen::MatrixXd Foam::fsi::rigidBodies::rigidField
(
    const Eigen::RowVectorXd& mean,
    const Eigen::Vector3d& momentum,
    const Eigen::MatrixXd& arms
) const
{
    // omega x r, row by row
    const Eigen::Matrix3d cross
    (
        crossMatrix(angularVelocityOf(moments(arms, arms), momentum))
    );
    const label nDims = shape().nDims();
    Eigen::MatrixXd v(arms*cross.topLeftCorner(nDims, nDims).transpose());
    v.rowwise() += mean;
    return v;
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
    response_.respond
    (
        masses_.asDiagonal()*startVelocities()/dt + force, v
    );
}


void Foam::fsi::rigidBodies::begin
(
    const scalar time,
    const scalar dt,
    const scalar ratio
)
{
    bodyGroup::begin(time, dt, ratio);
    const Eigen::MatrixXd lastPoints(lastPositions());
    const label nDims = shape().nDims();
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        // Each angular momentum with the arms it belongs to
        const Eigen::MatrixXd r(lessMean(ofCopy(oldPositions(), copyi)));
        const Eigen::MatrixXd before(lessMean(ofCopy(lastPoints, copyi)));
        const Eigen::Vector3d L
        (
            axialVector(moments(r, ofCopy(oldVelocities(), copyi)))
        );
        const Eigen::Vector3d lastL
        (
            axialVector(moments(before, ofCopy(lastVelocities(), copyi)))
        );
        const Eigen::Vector3d omega(angularVelocityOf(moments(r, r), L));
        const Eigen::Vector3d change
        (
            ratio
           *(omega - angularVelocityOf(moments(before, before), lastL))
        );
        const Eigen::Matrix3d turn
        (
            exponentialLess1(dt*(omega + 0.5*change))
        );
        const Eigen::MatrixXd arms
        (
            r + r*turn.topLeftCorner(nDims, nDims).transpose()
        );

        // The centre is where the rule for nodes has put it
        ofCopy(positions(), copyi) =
            arms.rowwise() + mean(ofCopy(positions(), copyi));
        ofCopy(velocities(), copyi) = rigidField
        (
            mean(ofCopy(velocities(), copyi)), L + ratio*(L - lastL), arms
        );
        setStartVelocities
        (
            nDims*copyi,
            rigidField
            (
                mean(ofCopy(startVelocities(), copyi)),
                L + backwardStep{ratio}.share()*(L - lastL),
                arms
            )
        );
    }
}


void Foam::fsi::rigidBodies::move(const scalar dt, const Eigen::MatrixXd& v)
{
    if (!secondOrder())
    {
        bodyGroup::move(dt, v);
        return;
    }
    const Eigen::MatrixXd expected(positions());
    bodyGroup::move(dt, v);
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        const Eigen::MatrixXd velocity(ofCopy(v, copyi));
        ofCopy(velocities(), copyi) = rigidField
        (
            mean(velocity),
            axialVector(moments(lessMean(ofCopy(expected, copyi)), velocity)),
            lessMean(ofCopy(positions(), copyi))
        );
    }
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
              - before
            )/dt;
        velocity.rowwise() += drift;
    }
}


// ************************************************************************* //
