// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphereSurfaces.H"
#include "../unit/samples/surfaceSamples.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fsi::surfaceSet Foam::fsi::sphereSurfaces
(
    const UList<point>& centres,
    const scalar radius,
    const label nCuts
)
{
    surfaceSet surfaces(3);
    for (const point& centre : centres)
    {
        appendSphere(surfaces, centre, radius, nCuts);
    }
    return surfaces;
}


// ************************************************************************* //
