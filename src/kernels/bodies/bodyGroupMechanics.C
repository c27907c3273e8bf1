// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroup.H"
#include "bodyVolume.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Value of a node of a copy; z is 0 in two dimensions
vector valueAt
(
    const Eigen::MatrixXd& values,
    const label nDims,
    const label nodei,
    const label copyi
)
{
    vector value(Zero);
    for (label i = 0; i < nDims; ++i)
    {
        value[i] = values(nodei, nDims*copyi + i);
    }
    return value;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::bodyGroup::massAverage
(
    const Eigen::MatrixXd& values,
    const label copyi
) const
{
    vector sum(Zero);
    for (label i = 0; i < shape().nDims(); ++i)
    {
        const auto column = values.col(shape().nDims()*copyi + i);
        forAll(shape().nodeMasses(), nodei)
        {
            sum[i] += shape().nodeMasses()[nodei]*column[nodei];
        }
    }
    return sum/Foam::sum(shape().nodeMasses());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyGroup::internalForce(Eigen::MatrixXd& force) const
{
    force.setZero(positions().rows(), positions().cols());
}


Foam::scalar Foam::fsi::bodyGroup::kineticEnergy() const
{
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape().nodeMasses().cdata(),
        shape().nNodes()
    );
    return 0.5*masses.dot(velocities().rowwise().squaredNorm());
}


Foam::scalar Foam::fsi::bodyGroup::volume(const label copyi) const
{
    return bodyVolume::of(shape().faces(), ofCopy(positions(), copyi));
}


Foam::point Foam::fsi::bodyGroup::centroid(const label copyi) const
{
    return massAverage(positions(), copyi);
}


Foam::vector Foam::fsi::bodyGroup::velocity(const label copyi) const
{
    return massAverage(velocities(), copyi);
}


Foam::vector Foam::fsi::bodyGroup::momentum(const label copyi) const
{
    return sum(shape().nodeMasses())*velocity(copyi);
}


Foam::vector Foam::fsi::bodyGroup::angularMomentum(const label copyi) const
{
    const label nDims = shape().nDims();
    const point centre(centroid(copyi));
    vector sum(Zero);
    forAll(shape().nodeMasses(), nodei)
    {
        const vector arm(valueAt(positions(), nDims, nodei, copyi) - centre);
        sum +=
            shape().nodeMasses()[nodei]
           *(arm ^ valueAt(velocities(), nDims, nodei, copyi));
    }
    return sum;
}


Foam::vector Foam::fsi::bodyGroup::angularVelocity(const label copyi) const
{
    const label nDims = shape().nDims();
    const point centre(centroid(copyi));
    symmTensor inertia(Zero);
    forAll(shape().nodeMasses(), nodei)
    {
        const vector arm(valueAt(positions(), nDims, nodei, copyi) - centre);
        inertia +=
            shape().nodeMasses()[nodei]*(magSqr(arm)*symmTensor::I - sqr(arm));
    }
    const vector moment(angularMomentum(copyi));
    if (nDims == 2)
    {
        return moment/inertia.zz();
    }
    return inv(inertia) & moment;
}


// ************************************************************************* //
