// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidBodies.H"
#include "backwardStep.H"
#include "rigidTurn.H"
#include "stepMatrix.H"

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


void Foam::fsi::rigidBodies::setMasses(const scalar dt) const
{
    if (!shape().held().empty())
    {
        const scalarField masses(stepMasses(shape(), dt));
        masses_ =
            Eigen::Map<const Eigen::VectorXd>(masses.cdata(), masses.size());
    }
}


Eigen::Vector3d Foam::fsi::rigidBodies::angularVelocityBy
(
    const Eigen::Matrix3d& S,
    const Eigen::Vector3d& L
) const
{
    if (freedom().turnsFreely())
    {
        return angularVelocityOf(S, L);
    }
    Eigen::Vector3d omega(Eigen::Vector3d::Zero());
    for (const direction axis : freedom().rotations())
    {
        omega[axis] = L[axis]/(S.trace() - S(axis, axis));
    }
    return omega;
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
        crossMatrix(angularVelocityBy(moments(arms, arms), momentum))
    );
    const label nDims = shape().nDims();
    Eigen::MatrixXd v(arms*cross.topLeftCorner(nDims, nDims).transpose());
    v.rowwise() += mean;
    return v;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rigidBodies::rigidBodies(const shapeTemplate& shape)
:
    rigidBodies(shape, bodyFreedom(shape.nDims()))
{}


Foam::fsi::rigidBodies::rigidBodies
(
    const shapeTemplate& shape,
    const bodyFreedom& freedom
)
:
    bodyGroup(shape, freedom),
    ownMasses_
    (
        Eigen::Map<const Eigen::VectorXd>
        (
            shape.nodeMasses().cdata(), shape.nNodes()
        )
    ),
    masses_(ownMasses_),
    arms_(shape.nNodes(), shape.nDims()),
    response_(shape, freedom)
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
    const scalar time,
    const scalar dt,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (!response_.preparedFor(dt, positions()))
    {
        response_.prepare(dt, positions());
    }
    setMasses(dt);
    Eigen::MatrixXd total(ownMasses_.asDiagonal()*startVelocities()/dt + force);
    const labelList& held = shape().held().nodes();
    const Eigen::MatrixXd places(heldPlaces(time, dt));
    for (label k = 0; k < held.size(); ++k)
    {
        const label i = held[k];
        total.row(i) +=
            (masses_[i] - ownMasses_[i])/sqr(dt)
           *(places.row(k) - start().row(i));
    }
    response_.respond(total, v);
}


void Foam::fsi::rigidBodies::begin
(
    const scalar time,
    const scalar dt,
    const scalar ratio
)
{
    bodyGroup::begin(time, dt, ratio);
    setMasses(backwardStep{ratio}.length(dt));
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
        const Eigen::Vector3d omega(angularVelocityBy(moments(r, r), L));
        const Eigen::Vector3d change
        (
            ratio
           *(omega - angularVelocityBy(moments(before, before), lastL))
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


void Foam::fsi::rigidBodies::jump
(
    const scalar part,
    const Eigen::MatrixXd& dv
)
{
    const Eigen::MatrixXd before(lastVelocities());
    bodyGroup::jump(part, dv);
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        // The angular momentum jumps, with the arms of x^n
        const Eigen::MatrixXd arms(lessMean(ofCopy(oldPositions(), copyi)));
        const Eigen::MatrixXd change(ofCopy(dv, copyi));
        const Eigen::MatrixXd mine(lessMean(ofCopy(positions(), copyi)));
        setLastVelocities
        (
            shape().nDims()*copyi,
            rigidField
            (
                mean(ofCopy(lastVelocities(), copyi)),
                axialVector
                (
                    moments(arms, ofCopy(before, copyi))
                  + moments(mine, change)
                ),
                arms
            )
        );
    }
}


void Foam::fsi::rigidBodies::prepareResponse(const scalar dt)
{
    setMasses(dt);
    response_.prepare(dt, positions());
}


// ************************************************************************* //
