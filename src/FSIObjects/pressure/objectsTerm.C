// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsTerm.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectsTerm::objectsTerm(const fsiSystem& system)
:
    system_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::objectsTerm::velocity
(
    const scalarField& p,
    vectorField& v
) const
{
    system_.walls.transposeAtWalls(p, nodal_);
    nodal_ *= system_.fluidDensity;
    system_.objects.layout().toBoundary(nodal_, force_);

    velocity_.setSize(force_.size());
    forAll(force_, groupi)
    {
        velocity_[groupi].resize(force_[groupi].rows(), force_[groupi].cols());
        system_.objects.groups()[groupi].response().respondBoundary
        (
            force_[groupi],
            velocity_[groupi]
        );
    }
    system_.objects.layout().toSurface(velocity_, v);
}


void Foam::fsi::objectsTerm::add
(
    scalarField& Ax,
    const scalarField& x
) const
{
    // J' is +1 outward of the lower cell, and p pushes the nodes outward of
    // the fluid with the same sign: K is positive semi-definite
    velocity(x, nodal_);
    system_.walls.addFluxAtWalls(nodal_, Ax);
}


// ************************************************************************* //
