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
        for (const filmSide& side : (*links_)[i].sides)
        {
            change += 0.5*side.velocity(v);
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
        for (const filmSide& side : (*links_)[i].sides)
        {
            side.spread(force.mine(), density*parts_[i]*middle_[i]);
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
        const FixedList<filmSide, 2>& sides = (*links_)[i].sides;
        const vector half
        (
            0.5*density*parts_[i]*(sides[1].velocity(v) - sides[0].velocity(v))
        );
        sides[0].spread(force.mine(), half);
        sides[1].spread(force.mine(), -half);
    }
}


// ************************************************************************* //
