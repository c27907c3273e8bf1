// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfacesInBox.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::fsi::boxLayout sharedAlong(const Foam::direction split)
{
    Foam::fsi::boxLayout layout;
    layout.splitDirection = split;
    return layout;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfacesInBox::surfacesInBox
(
    const labelVector& n,
    const direction nDims,
    const direction split
)
:
    box_(n, nDims, sharedAlong(split)),
    grid_(box_.mesh()),
    wall_(wallTreatment::New(dictionary())),
    levelSet_(levelSetUpdate::New(grid_, dictionary())),
    surfaces_(nDims),
    geometry_(grid_, *wall_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::surfacesInBox::move(const surfaceSet& surfaces)
{
    surfaces_ = surfaces;
    levelSet_->initialise(surfaces_);
    geometry_.update(*levelSet_, surfaces_);
}


// ************************************************************************* //
