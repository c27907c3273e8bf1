// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodiesTerm.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodiesTerm::bodiesTerm(const fsiSystem& system)
:
    system_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodiesTerm::velocity
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
        respond(groupi, force_[groupi], velocity_[groupi]);
    }
    system_.objects.layout().toSurface(velocity_, v);
}


void Foam::fsi::bodiesTerm::add
(
    scalarField& Ax,
    const scalarField& x
) const
{
    // J' is +1 outward of the lower cell, and p pushes the nodes outward of
    // the fluid with the same sign: the term is positive semi-definite
    velocity(x, nodal_);
    system_.walls.addFluxAtWalls(nodal_, Ax);
}


// ************************************************************************* //
