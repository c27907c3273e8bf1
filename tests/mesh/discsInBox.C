// SPDX-License-Identifier: GPL-3.0-or-later

#include "discsInBox.H"
#include "discSurfaces.H"

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


// * * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * //

constexpr Foam::scalar Foam::fsi::discsInBox::radius;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::discsInBox::discsInBox(const direction split)
:
    box_(labelVector(32, 20, 1), 2, sharedAlong(split)),
    grid_(box_.mesh()),
    wall_(wallTreatment::New(dictionary())),
    levelSet_(levelSetUpdate::New(grid_, dictionary())),
    surfaces_(2),
    geometry_(grid_, *wall_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::discsInBox::move(const List<point>& centres)
{
    surfaces_ = discSurfaces(centres, radius, 96);
    levelSet_->initialise(surfaces_);
    geometry_.update(*levelSet_, surfaces_);
}


// ************************************************************************* //
