// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribedBodies.H"
#include "backwardStep.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::prescribedBodies::prescribedBodies
(
    const shapeTemplate& shape,
    autoPtr<bodyMotion> motion
)
:
    bodyGroup(shape),
    motion_(std::move(motion)),
    response_(shape)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::prescribedBodies::displacement
(
    const scalar time,
    const scalar dt,
    Eigen::MatrixXd& d
) const
{
    const label nDims = shape().nDims();
    const auto step = motion_->between(time, time + dt, nDims);
    d.resize(positions().rows(), positions().cols());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        const point centre(centroid(copyi));
        Eigen::RowVectorXd about(nDims);
        for (label i = 0; i < nDims; ++i)
        {
            about[i] = centre[i];
        }
        ofCopy(d, copyi) = step.of(ofCopy(positions(), copyi), about);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::prescribedBodies::begin
(
    const scalar time,
    const scalar dt,
    const scalar ratio
)
{
    Eigen::MatrixXd d;
    displacement(time - dt, dt, d);
    bodyGroup::begin(time, dt, ratio);
    positions() = oldPositions() + d;
    velocities() = (positions() - start())/backwardStep{ratio}.length(dt);
}


void Foam::fsi::prescribedBodies::predict
(
    const scalar time,
    const scalar dt,
    const Eigen::MatrixXd&,
    Eigen::MatrixXd& v
) const
{
    if (secondOrder())
    {
        v = velocities();
        return;
    }
    displacement(time, dt, v);
    for (Eigen::Index i = 0; i < v.size(); ++i)
    {
        v.data()[i] /= dt;
    }
}


void Foam::fsi::prescribedBodies::prepareResponse(const scalar dt)
{
    response_.prepare(dt, positions());
}


// ************************************************************************* //
