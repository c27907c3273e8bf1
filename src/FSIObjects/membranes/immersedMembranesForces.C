// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedMembranes.H"
#include "bodyVolume.H"
#include "membraneStep.H"

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
    const shapeTemplate& shape = group.shape();
    const label nDims = shape.nDims();
    const Eigen::VectorXd along
    (
        Eigen::Vector3d(weight.x(), weight.y(), weight.z()).head(nDims)
    );
    for (label i = 0; i < group.size() && mag(weight) > 0; ++i)
    {
        const Eigen::MatrixXd x(group.positions().middleCols(nDims*i, nDims));
        Eigen::MatrixXd area(Eigen::MatrixXd::Zero(x.rows(), nDims));
        bodyVolume::addGradient(shape.faces(), shape.thickness(), x, area);
        // Any constant makes the same sum; that of the middle leaves least
        // force across the sheet
        const Eigen::VectorXd pressure(x*along);
        force.middleCols(nDims*i, nDims) +=
            (pressure.array() - pressure.mean()).matrix().asDiagonal()*area;
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
    const membraneForceStep step(membraneStepOf(objects_, deltaT));
    slip_.resize(force.size());
    forAll(force, groupi)
    {
        bodyGroup& group = bodies_.groups()[groupi];
        if (!group.hasWalls())
        {
            dynamic_cast<immersedBodies&>(group).stepForces
            (
                step, force[groupi]
            );
            addWeight(group, force[groupi]);
            force[groupi] += given[groupi];
            dynamic_cast<const immersedBodies&>(group).slip
            (
                step, force[groupi], slip_[groupi]
            );
            force[groupi] /= fluid_.density;
        }
    }
    bodies_.layout().toSurface(force, nodal_);
}


// ************************************************************************* //
