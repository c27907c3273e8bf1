// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmFriction.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmFriction::set
(
    const UList<filmLink>& links,
    const scalar viscosity,
    const vectorField& v
)
{
    links_ = &links;
    parts_.setSize(links.size());
    middle_.setSize(links.size());
    middle_ = Zero;
    forAll(links, i)
    {
        parts_[i] = 2*viscosity*links[i].conductance;
    }
    relax(v, 1);
}


Foam::scalar Foam::fsi::filmFriction::relax
(
    const vectorField& v,
    const scalar relaxation,
    const scalar scale
)
{
    scalar squares = 0;
    forAll(*links_, i)
    {
        vector change(-middle_[i]);
        for (const surfacePlace& place : (*links_)[i].places)
        {
            change += 0.5*place.interpolate(v);
        }
        squares += magSqr(scale*(2*parts_[i]*change));
        middle_[i] += relaxation*change;
    }
    return squares;
}


void Foam::fsi::filmFriction::addForce
(
    const scalar density,
    partialForces& force
) const
{
    forAll(*links_, i)
    {
        for (const surfacePlace& place : (*links_)[i].places)
        {
            place.spread
            (
                force.mine(), vector(density*parts_[i]*middle_[i])
            );
        }
    }
}


void Foam::fsi::filmFriction::addForce
(
    const scalar density,
    const vectorField& v,
    partialForces& force
) const
{
    forAll(*links_, i)
    {
        const FixedList<surfacePlace, 2>& places = (*links_)[i].places;
        const vector half
        (
            0.5*density*parts_[i]
           *(places[1].interpolate(v) - places[0].interpolate(v))
        );
        places[0].spread(force.mine(), half);
        places[1].spread(force.mine(), vector(-half));
    }
}


// ************************************************************************* //
