// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedMembranes.H"
#include "bodyVolume.H"
#include "immersedBodies.H"
#include "partialForces.H"
#include "readBetween.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Points of the kernel
static label readKernel(const dictionary& dict)
{
    checkKeys(dict, {"kernel"});
    return readBetween(dict, "kernel", 3, 2, 4);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Action>
void Foam::fsi::immersedMembranes::forMembranes(const Action& action) const
{
    const surfaceSet& surfaces = bodies_.surfaces();
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (!surfaces.hasWalls(objecti))
        {
            const label start = surfaces.pointStart()[objecti];
            action(start, surfaces.pointStart()[objecti + 1] - start);
        }
    }
}


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


void Foam::fsi::immersedMembranes::setForces(const scalar deltaT)
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
            force[groupi] /= fluid_.density;
        }
    }
    bodies_.layout().toSurface(force, nodal_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::immersedMembranes::immersedMembranes
(
    const population& bodies,
    const interfaceGeometry& geometry,
    const fluidProperties& fluid,
    const vector& gravity,
    const dictionary& dict
)
:
    bodies_(bodies),
    geometry_(geometry),
    fluid_(fluid),
    gravity_(gravity),
    width_(readKernel(dict))
{
    bool any = false;
    for (const bodyGroup& group : bodies.groups())
    {
        any = any || !group.hasWalls();
    }
    if (any)
    {
        faces_.reset(new faceLattice(geometry.grid()));
        transfer_.reset(new staggeredTransfer(faces_->lattice(), width_));
    }
    if (viscosityContrast::wanted(bodies, fluid))
    {
        contrast_.reset
        (
            new viscosityContrast(bodies, geometry, *faces_, fluid)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::immersedMembranes::alone(const population& bodies)
{
    for (const bodyGroup& group : bodies.groups())
    {
        if (group.hasWalls())
        {
            return false;
        }
    }
    return bodies.groups().size() > 0;
}


void Foam::fsi::immersedMembranes::spread
(
    const volVectorField& U,
    const stepLength& step
)
{
    if (!active())
    {
        return;
    }
    setForces(step.dt);
    faces_->setZero(values_);
    const pointField& x = bodies_.surfaces().points();
    forMembranes([&](const label start, const label n)
    {
        transfer_->spread
        (
            SubList<point>(x, n, start),
            SubList<vector>(nodal_, n, start),
            values_
        );
    });
    faces_->setCells(U, values_, force_);
    const boolList& inFluid = geometry_.fluidCell();
    forAll(force_, celli)
    {
        if (!inFluid[celli])
        {
            force_[celli] = Zero;
        }
    }
    if (contrast_.valid())
    {
        contrast_->update(bodies_);
    }
}


void Foam::fsi::immersedMembranes::addTo(fvVectorMatrix& UEqn) const
{
    if (active())
    {
        UEqn.source() += force_;
    }
    if (contrast_.valid())
    {
        contrast_->add(UEqn);
    }
}


void Foam::fsi::immersedMembranes::correctPressure
(
    const volScalarField& last,
    const stepLength& step,
    volScalarField& p
) const
{
    if (active())
    {
        // A larger viscosity inside would make short waves grow
        scalarField nu(p.size(), fluid_.viscosity);
        if (contrast_.valid())
        {
            nu += min(contrast_->more(), scalar(0));
        }
        addRotationalPart(geometry_, nu, last, step.tau, p);
    }
}


void Foam::fsi::immersedMembranes::setVelocities
(
    const surfaceScalarField& phi,
    const volVectorField& U,
    const scalar deltaT,
    nodeLayout::groupNodal& v
)
{
    if (!active())
    {
        return;
    }
    faces_->setVelocities(phi, geometry_.openArea(), U, values_);
    const pointField& x = bodies_.surfaces().points();
    partialForces part(x.size());
    forMembranes([&](const label start, const label n)
    {
        SubList<vector> nodes(part.mine(), n, start);
        transfer_->interpolate(SubList<point>(x, n, start), values_, nodes);
    });
    nodeLayout::groupNodal velocity;
    bodies_.layout().toGroups(part.collect(bodies_.ranks()), velocity);
    forAll(velocity, groupi)
    {
        const bodyGroup& group = bodies_.groups()[groupi];
        if (!group.hasWalls())
        {
            v[groupi] = velocity[groupi];
            dynamic_cast<const immersedBodies&>(group).keepVolume
            (
                deltaT, v[groupi]
            );
        }
    }
}


// ************************************************************************* //
