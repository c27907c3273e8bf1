// SPDX-License-Identifier: GPL-3.0-or-later

#include "leastModulus.H"
#include "cartesianMesh.H"
#include "population.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::leastModulus
(
    const population& bodies,
    const cartesianMesh& grid
)
{
    const PtrList<bodyGroup>& groups = bodies.groups();
    // A step of zero is refused later, with its entry
    const scalar deltaT = grid.mesh().time().deltaTValue();
    const scalar speed = grid.spacing()/max(deltaT, SMALL);
    scalar least = GREAT, leastFree = GREAT;
    for (const bodyGroup& group : groups)
    {
        if (!group.hasWalls())
        {
            continue;
        }
        const shapeTemplate& shape = group.shape();
        const scalar modulus =
            shape.rigid()
          ? shape.density()*sqr(speed)
          : shape.youngsModulus();
        least = min(least, modulus);
        if (group.movesFreely())
        {
            leastFree = min(leastFree, modulus);
        }
    }
    if (leastFree < GREAT)
    {
        return leastFree;
    }
    // Without shapes nothing touches, and any value will do
    return least < GREAT ? least : 1;
}


// ************************************************************************* //
