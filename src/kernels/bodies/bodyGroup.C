// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyMotion.H"
#include "elasticBodies.H"
#include "immersedBodies.H"
#include "openfoamVersion.H"
#include "prescribedBodies.H"
#include "rigidBodies.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyGroup::bodyGroup(const shapeTemplate& shape)
:
    bodyGroup(shape, bodyFreedom(shape.nDims()))
{}


Foam::fsi::bodyGroup::bodyGroup
(
    const shapeTemplate& shape,
    const bodyFreedom& freedom
)
:
    bodyCopies(shape),
    freedom_(freedom)
{}


Foam::fsi::bodyGroup::~bodyGroup() = default;


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fsi::bodyGroup> Foam::fsi::bodyGroup::New
(
    const shapeTemplate& shape,
    const dictionary& motionDict
)
{
    autoPtr<bodyMotion> motion(bodyMotion::New(motionDict));
    if (motion.valid() && shape.held().empty())
    {
        return autoPtr<bodyGroup>
        (
            new prescribedBodies(shape, std::move(motion))
        );
    }
    autoPtr<bodyGroup> group(newFree(shape, motionDict));
    group->heldMotion_ = std::move(motion);
    return group;
}


Foam::autoPtr<Foam::fsi::bodyGroup> Foam::fsi::bodyGroup::newFree
(
    const shapeTemplate& shape,
    const dictionary& motionDict
)
{
    const bodyFreedom freedom(motionDict, shape.nDims());
    if (shape.rigid())
    {
        return autoPtr<bodyGroup>(new rigidBodies(shape, freedom));
    }
    if
    (
        shape.sheet()
     && !(freedom.movesFreely() && freedom.turnsFreely())
    )
    {
        FatalIOErrorInFunction(motionDict)
            << "Entries 'translations' and 'rotations' in dictionary "
            << motionDict.name() << " are for elastic and rigid bodies, but the"
            << " material of shape " << shape.name() << " is a membrane"
            << exit(FatalIOError);
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
    return autoPtr<bodyGroup>(new elasticBodies(shape, freedom));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    if
    (
        !freedom_.allows(velocity, angularVelocity)
     || (
            shape().held().clamped().size()
         && mag(velocity) + mag(angularVelocity) > 0
        )
    )
    {
        FatalErrorInFunction
            << "An object of shape " << shape().name() << " at " << centre
            << " begins with the velocity " << velocity
            << " m/s and the angular velocity " << angularVelocity
            << " rad/s, but entries 'translations' and 'rotations' of its"
            << " motion, or 'hold' of its shape, do not let it move so"
            << exit(FatalError);
    }
    const label copyi = made < 0 ? size() : made;
    resize(max(size(), copyi + 1));
    const label nDims = shape().nDims();
    startCopy(copyi, objectId);
    startState(copyi);

    forAll(shape().points(), nodei)
    {
        const vector arm = rotation & shape().points()[nodei];
        const vector nodeVelocity = velocity + (angularVelocity ^ arm);
        for (label i = 0; i < nDims; ++i)
        {
            positions()(nodei, nDims*copyi + i) = centre[i] + arm[i];
            velocities()(nodei, nDims*copyi + i) = nodeVelocity[i];
        }
    }
    startNodes(nDims*copyi, nDims);
    setAnchors(copyi);
    return copyi;
}


Eigen::MatrixXd Foam::fsi::bodyGroup::heldPlaces
(
    const scalar time,
    const scalar dt
) const
{
    Eigen::MatrixXd places(anchors());
    if (!heldMotion_.valid() || places.rows() == 0)
    {
        return places;
    }
    const scalar end = time + (secondOrder() ? wholeStep() : dt);
    const auto step = heldMotion_->between(0, end, shape().nDims());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        auto ofOne = ofCopy(places, copyi);
        ofOne += step.of(ofOne, ofOne.colwise().mean());
    }
    return places;
}


void Foam::fsi::bodyGroup::move(const scalar dt, const Eigen::MatrixXd& v)
{
    finishNodes(dt, v);
}


void Foam::fsi::bodyGroup::write(Ostream& os) const
{
    const int oldPrecision = os.precision(17);
    writeCopies(os);
    writeState(os);

    os.precision(oldPrecision);
}


void Foam::fsi::bodyGroup::read(const dictionary& dict)
{
    readCopies(dict);
    readState(dict);
}


// ************************************************************************* //
