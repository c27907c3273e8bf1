// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroup.H"
#include "elementViscosity.H"
#include "error.H"
#include "innerFlow.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::bodyGroup::resize(const label nCopies)
{
    const label nColumns = shape_.nDims()*nCopies;
    positions_.conservativeResize(shape_.nNodes(), nColumns);
    velocities_.conservativeResize(shape_.nNodes(), nColumns);
    meanLoad_.conservativeResize(shape_.nBoundaryNodes(), nColumns);
    if (shape_.law().hasState())
    {
        springStates_.conservativeResize(shape_.springs().size(), nCopies);
    }
    if (shape_.membrane())
    {
        triangles_.resize(nCopies, shape_.elements());
    }
    objectIds_.resize(nCopies, -1);
}


void Foam::fsi::bodyGroup::prescribe
(
    const scalar time,
    const scalar dt,
    Eigen::MatrixXd& v
) const
{
    const vector shift =
        motion_->displacement(time + dt) - motion_->displacement(time);
    const scalar turn =
        motion_->rotation(time + dt).z() - motion_->rotation(time).z();
    const scalar sine = std::sin(turn);
    const scalar versine = 2*sqr(std::sin(0.5*turn));

    v.resize(positions_.rows(), positions_.cols());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        const point centre(centroid(copyi));
        for (label nodei = 0; nodei < shape_.nNodes(); ++nodei)
        {
            const scalar x = positions_(nodei, 2*copyi) - centre.x();
            const scalar y = positions_(nodei, 2*copyi + 1) - centre.y();
            v(nodei, 2*copyi) = (shift.x() - versine*x - sine*y)/dt;
            v(nodei, 2*copyi + 1) = (shift.y() + sine*x - versine*y)/dt;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyGroup::bodyGroup
(
    const shapeTemplate& shape,
    const dictionary& motionDict
)
:
    shape_(shape),
    motion_(bodyMotion::New(motionDict)),
    solver_(shape),
    response_(shape)
{
    resize(0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::bodyGroup::append
(
    const point& centre,
    const tensor& rotation,
    const vector& velocity,
    const vector& angularVelocity,
    const label objectId
)
{
    const label copyi = size();
    const label nDims = shape_.nDims();
    resize(copyi + 1);
    objectIds_[copyi] = objectId;
    meanLoad_.rightCols(nDims).setZero();
    if (shape_.law().hasState())
    {
        springStates_.col(copyi).setZero();
    }

    forAll(shape_.points(), nodei)
    {
        const vector arm = rotation & shape_.points()[nodei];
        const vector nodeVelocity = velocity + (angularVelocity ^ arm);
        for (label i = 0; i < nDims; ++i)
        {
            positions_(nodei, nDims*copyi + i) = centre[i] + arm[i];
            velocities_(nodei, nDims*copyi + i) = nodeVelocity[i];
        }
    }
    return copyi;
}


void Foam::fsi::bodyGroup::remove(const label copyi)
{
    const label nDims = shape_.nDims();
    for (label next = copyi + 1; next < size(); ++next)
    {
        for (label i = 0; i < nDims; ++i)
        {
            const label to = nDims*(next - 1) + i;
            positions_.col(to) = positions_.col(to + nDims);
            velocities_.col(to) = velocities_.col(to + nDims);
            meanLoad_.col(to) = meanLoad_.col(to + nDims);
        }
        if (shape_.law().hasState())
        {
            springStates_.col(next - 1) = springStates_.col(next);
        }
        if (shape_.membrane())
        {
            triangles_[next - 1] = triangles_[next];
        }
        objectIds_[next - 1] = objectIds_[next];
    }
    resize(size() - 1);
}


Eigen::MatrixXd Foam::fsi::bodyGroup::splitLoad(Eigen::MatrixXd& load)
{
    // A quarter: stable where the response is up to 8 times as stiff
    const auto boundary = load.topRows(meanLoad_.rows());
    meanLoad_ += 0.25*(boundary - meanLoad_);

    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(load.rows(), load.cols());
    rest.topRows(meanLoad_.rows()) = boundary - meanLoad_;
    load -= rest;
    return rest;
}


void Foam::fsi::bodyGroup::predict
(
    const scalar time,
    const scalar dt,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (free() && shape_.membrane())
    {
        predictMembrane(dt, force, v);
    }
    else if (free())
    {
        predict(dt, force, labelRange(0, size()), v);
    }
    else
    {
        prescribe(time, dt, v);
    }
}


void Foam::fsi::bodyGroup::predict
(
    const scalar dt,
    const Eigen::MatrixXd& force,
    const labelRange& copies,
    Eigen::MatrixXd& v
) const
{
    const bool viscous = shape_.viscosity() > 0;
    Eigen::MatrixXd total;
    if (viscous)
    {
        total = force;
        elementViscosity::addForce
        (
            shape_,
            positions_,
            velocities_,
            copies,
            total
        );
    }
    solver_.solve
    (
        dt,
        {positions_, velocities_, viscous ? total : force, springStates_},
        copies,
        v
    );
}


void Foam::fsi::bodyGroup::prepareResponse(const scalar dt)
{
    if (free())
    {
        response_.prepare(dt, positions_, triangles_);
    }
}


void Foam::fsi::bodyGroup::respond
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (free())
    {
        response_.respond(force, v);
    }
    else
    {
        v.setZero(positions_.rows(), positions_.cols());
    }
}


void Foam::fsi::bodyGroup::respondBoundary
(
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (free())
    {
        response_.respondBoundary(force, v);
    }
    else
    {
        v.setZero(shape_.nBoundaryNodes(), positions_.cols());
    }
}


void Foam::fsi::bodyGroup::constrainVolume
(
    const scalar dt,
    Eigen::MatrixXd& v
) const
{
    if (free())
    {
        response_.constrainVolume(dt, v);
    }
}


void Foam::fsi::bodyGroup::move(const scalar dt, const Eigen::MatrixXd& v)
{
    positions_ += dt*v;
    velocities_ = v;

    forAll(triangles_, copyi)
    {
        innerFlow::renew
        (
            triangles_[copyi],
            positions_.middleCols(2*copyi, 2),
            shape_.nBoundaryNodes()
        );
    }

    if (shape_.law().hasState())
    {
        for (label copyi = 0; copyi < size(); ++copyi)
        {
            forAll(shape_.springs(), springi)
            {
                scalar& state = springStates_(springi, copyi);
                state = shape_.law().advanceState
                (
                    shape_.restLengths()[springi],
                    springLength(springi, copyi),
                    state,
                    dt
                );
            }
        }
    }
}


// ************************************************************************* //
