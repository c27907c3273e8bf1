// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodiesTerm.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodiesTerm::bodiesTerm
(
    const population& bodies,
    const wallOperator& walls,
    const scalar density,
    const bool films
)
:
    bodies_(bodies),
    walls_(walls),
    density_(density),
    films_(films)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodiesTerm::velocity
(
    const scalarField& p,
    vectorField& v
) const
{
    walls_.transposeAtWalls(p, nodal_, films_);
    nodal_ *= density_;
    bodies_.layout().toBoundary(nodal_, force_);

    velocity_.setSize(force_.size());
    forAll(force_, groupi)
    {
        velocity_[groupi].resize(force_[groupi].rows(), force_[groupi].cols());
        respond(groupi, force_[groupi], velocity_[groupi]);
    }
    bodies_.layout().toSurface(velocity_, v, false);
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
    walls_.addFluxAtWalls(nodal_, Ax, films_);
}


// ************************************************************************* //
