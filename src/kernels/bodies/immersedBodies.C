// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyVolume.H"
#include "matrixEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedBodies::immersedBodies(const shapeTemplate& shape)
:
    bodyGroup(shape),
    forces_
    (
        *shape.sheet(), shape.mesh(), shape.nodeSpacing(), shape.thickness()
    ),
    response_(shape),
    implicit_(forces_),
    slip_
    (
        *shape.sheet(), shape.mesh(), shape.nodeSpacing(), shape.thickness()
    )
{
    if (shape.sheet()->membraneViscosity > 0)
    {
        viscosity_.reset
        (
            new membraneViscosity
            (
                *shape.sheet(), shape.mesh(), shape.thickness()
            )
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::immersedBodies::stiffness(const label copyi) const
{
    return shape().sheet()->stiffness
    (
        shape().nodeSpacing(), forces_.largestRatio(positions(), copyi)
    );
}


Foam::scalar Foam::fsi::immersedBodies::explicitPart
(
    const membraneForceStep& step
) const
{
    // They do not grow with the stretch, and may have twice as much
    const scalar spacing = shape().nodeSpacing();
    return
        step.number(shape().sheet()->explicitStiffness(spacing))
       /(2*step.mostExplicit);
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::immersedBodies::resizeState(const label nCopies)
{
    elasticForces_.conservativeResize
    (
        shape().nNodes(), shape().nDims()*nCopies
    );
    if (viscosity_.valid())
    {
        viscosity_->resize(nCopies);
    }
}


void Foam::fsi::immersedBodies::startState(const label copyi)
{
    ofCopy(elasticForces_, copyi).setZero();
    if (viscosity_.valid())
    {
        viscosity_->start(copyi);
    }
}


void Foam::fsi::immersedBodies::exchangeState
(
    const label copyi,
    copyValues& values
)
{
    values.block(ofCopy(elasticForces_, copyi));
    if (viscosity_.valid())
    {
        values.block(viscosity_->natural().col(copyi));
    }
}


void Foam::fsi::immersedBodies::writeState(Ostream& os) const
{
    writeMatrix(os, "elasticForces", elasticForces_);
    if (viscosity_.valid())
    {
        writeMatrix(os, "naturalMetrics", viscosity_->natural());
    }
}


void Foam::fsi::immersedBodies::readState(const dictionary& dict)
{
    readMatrix(dict, "elasticForces", elasticForces_);
    if (viscosity_.valid())
    {
        readMatrix(dict, "naturalMetrics", viscosity_->natural());
        if (!viscosity_->sound())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'naturalMetrics' of shape " << shape().name()
                << " has values that no triangle can have"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::immersedBodies::begin(const scalar, const scalar, const scalar)
{
    FatalErrorInFunction
        << "Shape " << shape().name() << " is a membrane inside the fluid, for"
        << " which there is no time step of second order: take Euler for"
        << " ddtSchemes in system/fvSchemes" << exit(FatalError);
}


void Foam::fsi::immersedBodies::predict
(
    const scalar,
    const scalar,
    const Eigen::MatrixXd&,
    Eigen::MatrixXd& v
) const
{
    v = velocities();
}


void Foam::fsi::immersedBodies::prepareResponse(const scalar dt)
{
    response_.prepare(dt, positions());
}


void Foam::fsi::immersedBodies::keepVolume
(
    const scalar dt,
    const Eigen::MatrixXd& free,
    Eigen::MatrixXd& v
) const
{
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        const Eigen::MatrixXd x
        (
            ofCopy(positions(), copyi) + dt*ofCopy(v, copyi)
        );
        Eigen::MatrixXd along(Eigen::MatrixXd::Zero(x.rows(), x.cols()));
        bodyVolume::addGradient(shape().faces(), 1, x, along);
        const Eigen::MatrixXd freely(along.cwiseProduct(ofCopy(free, copyi)));
        if (freely.squaredNorm() > fewFree*along.squaredNorm())
        {
            along = freely;
        }
        const scalar factor = bodyVolume::factorAlongGradient
        (
            shape().faces(), x, along, shape().referenceVolume()
        );
        ofCopy(v, copyi) += factor/dt*along;
    }
}


void Foam::fsi::immersedBodies::move(const scalar dt, const Eigen::MatrixXd& v)
{
    bodyGroup::move(dt, v);
    if (viscosity_.valid())
    {
        viscosity_->relax(dt, positions());
    }
}


void Foam::fsi::immersedBodies::internalForce(Eigen::MatrixXd& force) const
{
    forces_.energy(positions(), &force);
    if (viscosity_.valid())
    {
        viscosity_->addForce(positions(), force);
    }
}


Foam::scalar Foam::fsi::immersedBodies::elasticEnergy() const
{
    return forces_.energy(positions());
}


void Foam::fsi::immersedBodies::stepForces
(
    const membraneForceStep& inFluid,
    Eigen::MatrixXd& force
)
{
    const membraneForceStep step(inFluid.around(*shape().sheet()));
    const scalar longest = step.most(*shape().sheet());
    DynamicList<label> soft, stiff;
    scalar most = explicitPart(step);
    slipPasses_.setSize(size());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        const scalar modulus = stiffness(copyi);
        const scalar number = step.number(modulus);
        slipPasses_[copyi] = slip_.passes(step, modulus);
        most = max(most, number/longest);
        (number > step.mostExplicit ? stiff : soft).append(copyi);
    }
    if (most > 1)
    {
        FatalErrorInFunction
            << "The time step " << step.dt << " s is too long for the membranes"
            << " of shape " << shape().name() << " as they are stretched" << nl
            << "Take a step of " << step.dt/most << " s or less,"
            << " adjustTimeStep yes, or smaller moduli"
            << (step.viscosity < inFluid.viscosity
              ? ", or a larger innerViscosity" : "")
            << exit(FatalError);
    }
    force = elasticForces_;
    forces_.energy(positions(), soft, &force);
    if (stiff.size())
    {
        implicit_.correct
        (
            stiff,
            step.dt*forces_.mobility()/step.viscosity,
            positions(),
            positions() + step.dt*velocities(),
            force
        );
    }
    elasticForces_ = force;
    if (viscosity_.valid())
    {
        viscosity_->addForce(positions(), force);
    }
}


void Foam::fsi::immersedBodies::slip
(
    const membraneForceStep& step,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    v.setZero(force.rows(), force.cols());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        slip_.add
        (
            step,
            slipPasses_[copyi],
            ofCopy(positions(), copyi),
            ofCopy(force, copyi),
            ofCopy(v, copyi)
        );
    }
}


Foam::scalar Foam::fsi::immersedBodies::longestStep
(
    const membraneForceStep& inFluid
) const
{
    const membraneForceStep step(inFluid.around(*shape().sheet()));
    const scalar longest = step.most(*shape().sheet());
    scalar most = explicitPart(step);
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        most = max(most, step.number(stiffness(copyi))/longest);
    }
    return step.dt/max(most, VSMALL);
}


// ************************************************************************* //
