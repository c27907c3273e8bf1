// SPDX-License-Identifier: GPL-3.0-or-later

#include "discsInBox.H"
#include "discSurfaces.H"

// * * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * //

constexpr Foam::scalar Foam::fsi::discsInBox::radius;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::discsInBox::discsInBox(const direction split)
:
    surfacesInBox(labelVector(32, 20, 1), 2, split)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::discsInBox::move(const List<point>& centres)
{
    surfacesInBox::move(discSurfaces(centres, radius, 96));
}


// ************************************************************************* //
