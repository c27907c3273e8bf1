// SPDX-License-Identifier: GPL-3.0-or-later

#include "nodeVelocities.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::nodeVelocities::nodeVelocities(const nodeLayout& layout)
:
    layout_(layout)
{
    reset();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::nodeVelocities::reset()
{
    layout_.zero(change());
}


const Foam::vectorField& Foam::fsi::nodeVelocities::surface() const
{
    if (!current_)
    {
        layout_.wallsToSurface(groups_, surface_);
        current_ = true;
    }
    return surface_;
}


// ************************************************************************* //
