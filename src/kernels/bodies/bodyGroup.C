// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"
#include "elasticBodies.H"
#include "groupEntries.H"
#include "immersedBodies.H"
#include "matrixEntry.H"
#include "membraneBodies.H"
#include "openfoamVersion.H"
#include "prescribedBodies.H"
#include "rigidBodies.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyGroup::bodyGroup(const shapeTemplate& shape)
:
    shape_(shape)
{
    resizeNodes(shape.nNodes(), 0);
    owedImpulse_.resize(shape.nBoundaryNodes(), 0);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::bodyGroup> Foam::fsi::bodyGroup::New
(
    const shapeTemplate& shape,
    const dictionary& motionDict
)
{
    autoPtr<bodyMotion> motion(bodyMotion::New(motionDict));
    if (motion.valid())
    {
        return autoPtr<bodyGroup>
        (
            new prescribedBodies(shape, std::move(motion))
        );
    }
    if (shape.rigid())
    {
        return autoPtr<bodyGroup>(new rigidBodies(shape));
    }
    if (shape.sheet())
    {
        return autoPtr<bodyGroup>(new immersedBodies(shape));
    }
    if (shape.elements().empty())
    {
        FatalIOErrorInFunction(motionDict)
            << "Shape " << shape.name() << " has a surface alone, without"
            << " elements inside, so that it is rigid or has a prescribed"
            << " motion; entry 'type' of its material is none of rigid, or"
            << " entry 'type' of its motion is free" << exit(FatalIOError);
    }
    if (shape.membrane())
    {
        return autoPtr<bodyGroup>(new membraneBodies(shape));
    }
    return autoPtr<bodyGroup>(new elasticBodies(shape));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyGroup::resize(const label nCopies)
{
    resizeNodes(shape_.nNodes(), shape_.nDims()*nCopies);
    objectIds_.resize(nCopies, -1);
    const label nColumns = shape_.nDims()*nCopies;
    owedImpulse_.conservativeResize(shape_.nBoundaryNodes(), nColumns);
    resizeState(nCopies);
}


Foam::label Foam::fsi::bodyGroup::append
(
    const point& centre,
    const tensor& rotation,
    const vector& velocity,
    const vector& angularVelocity,
    const label objectId,
    const label made
)
{
    const label copyi = made < 0 ? size() : made;
    resize(max(size(), copyi + 1));
    const label nDims = shape_.nDims();
    objectIds_[copyi] = objectId;
    ofCopy(owedImpulse_, copyi).setZero();
    startState(copyi);

    forAll(shape_.points(), nodei)
    {
        const vector arm = rotation & shape_.points()[nodei];
        const vector nodeVelocity = velocity + (angularVelocity ^ arm);
        for (label i = 0; i < nDims; ++i)
        {
            positions()(nodei, nDims*copyi + i) = centre[i] + arm[i];
            velocities()(nodei, nDims*copyi + i) = nodeVelocity[i];
        }
    }
    startNodes(nDims*copyi, nDims);
    return copyi;
}


void Foam::fsi::bodyGroup::remove(const label copyi)
{
    for (label next = copyi + 1; next < size(); ++next)
    {
        const label n = shape_.nDims();
        copyNodes(n*next, n*(next - 1), n);
        objectIds_[next - 1] = objectIds_[next];
        ofCopy(owedImpulse_, next - 1) = ofCopy(owedImpulse_, next);
        copyState(next, next - 1);
    }
    resize(size() - 1);
}


void Foam::fsi::bodyGroup::predictRange
(
    const scalar,
    const Eigen::MatrixXd&,
    const labelRange&,
    Eigen::MatrixXd&
) const
{
    FatalErrorInFunction
        << "The copies of shape " << shape_.name()
        << " are predicted all at once only" << exit(FatalError);
}


void Foam::fsi::bodyGroup::move(const scalar dt, const Eigen::MatrixXd& v)
{
    finishNodes(dt, v);
}


void Foam::fsi::bodyGroup::write(Ostream& os) const
{
    const int oldPrecision = os.precision(17);

    putEntry(os, "shape", shape_.name());
    putList(os, "objectIds", objectIds_);
    writeNodes(os);
    writeMatrix(os, "owedImpulse", owedImpulse_);
    writeState(os);

    os.precision(oldPrecision);
}


void Foam::fsi::bodyGroup::read(const dictionary& dict)
{
    const labelList ids(readGroupIds(dict, shape_.name()));
    resize(ids.size());
    objectIds_ = ids;
    readNodes(dict);
    readMatrix(dict, "owedImpulse", owedImpulse_);
    readState(dict);
}


// ************************************************************************* //
