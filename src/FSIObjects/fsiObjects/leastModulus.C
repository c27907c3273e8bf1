// SPDX-License-Identifier: GPL-3.0-or-later

#include "leastModulus.H"
#include "population.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::leastModulus
(
    const population& bodies
)
{
    scalar least = GREAT, leastFree = GREAT;
    for (const bodyGroup& group : bodies.groups())
    {
        if (!group.hasWalls() || group.shape().rigid())
        {
            continue;
        }
        const scalar modulus = group.shape().youngsModulus();
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
    return least < GREAT ? least : 0;
}


// ************************************************************************* //
