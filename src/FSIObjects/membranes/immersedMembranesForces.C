// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedMembranes.H"
#include "bodyVolume.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::immersedMembranes::addWeight
(
    const bodyGroup& group,
    Eigen::MatrixXd& force
) const
{
    const vector weight
    (
        (group.shape().density() - fluid_.density)*gravity_
    );
    const Eigen::Vector3d along(weight.x(), weight.y(), weight.z());
    for (label i = 0; i < group.size() && mag(weight) > 0; ++i)
    {
        const Eigen::MatrixXd x(group.positions().middleCols(3*i, 3));
        Eigen::MatrixXd area(Eigen::MatrixXd::Zero(x.rows(), 3));
        bodyVolume::addGradient(group.shape().faces(), 1, x, area);
        force.middleCols(3*i, 3) += (x*along).asDiagonal()*area;
    }
}


void Foam::fsi::immersedMembranes::checkStep
(
    const bodyGroup& group,
    const scalar deltaT
) const
{
    const shapeTemplate& shape = group.shape();
    const scalar h = geometry_.grid().spacing();
    const scalar ratio =
        deltaT*shape.sheet()->stiffness(shape.nodeSpacing())
       /(fluid_.dynamicViscosity()*h);
    if (ratio > stepLimit)
    {
        FatalErrorInFunction
            << "The time step " << deltaT << " s is too long for the membranes"
            << " of shape " << shape.name() << ": dt a/(mu h) is " << ratio
            << " but must be " << stepLimit << " at most, with the largest"
            << " modulus a of their material" << nl
            << "Take a step of " << deltaT*stepLimit/ratio
            << " s or less, or a smaller areaModulus" << exit(FatalError);
    }
}


void Foam::fsi::immersedMembranes::addPart
(
    partialForces& part,
    nodeLayout::groupNodal& force
) const
{
    nodeLayout::groupNodal inGroups;
    bodies_.layout().toGroups(part.collect(bodies_.ranks()), inGroups);
    nodeLayout::add(inGroups, force);
}


void Foam::fsi::immersedMembranes::addContact
(
    const scalar deltaT,
    nodeLayout::groupNodal& force
)
{
    partialForces part(bodies_.surfaces().points().size());
    contact_->add(deltaT, part.mine());
    if (!bodies_.ranks().shared())
    {
        addPart(part, force);
        return;
    }
    // Each rank has found all pairs
    nodeLayout::groupNodal inGroups;
    bodies_.layout().toGroups(part.mine(), inGroups);
    nodeLayout::add(inGroups, force);
}


void Foam::fsi::immersedMembranes::setForces
(
    const scalar deltaT,
    const nodeLayout::groupNodal& given
)
{
    nodeLayout::groupNodal force;
    bodies_.layout().zero(force);
    forAll(force, groupi)
    {
        const bodyGroup& group = bodies_.groups()[groupi];
        if (!group.hasWalls())
        {
            checkStep(group, deltaT);
            group.internalForce(force[groupi]);
            addWeight(group, force[groupi]);
            force[groupi] += given[groupi];
            force[groupi] /= fluid_.density;
        }
    }
    bodies_.layout().toSurface(force, nodal_);
}


// ************************************************************************* //
