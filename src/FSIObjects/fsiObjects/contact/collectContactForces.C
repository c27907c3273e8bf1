// SPDX-License-Identifier: GPL-3.0-or-later

#include "collectContactForces.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::collectContactForces
(
    const population& bodies,
    vectorField& force
)
{
    bool allFree = true;
    for (const bodyGroup& group : bodies.groups())
    {
        allFree = allFree && group.movesFreely();
    }
    if (allFree || bodies.ranks().shared())
    {
        return;
    }
    const surfaceSet& surfaces = bodies.surfaces();
    force.setSize(surfaces.points().size(), Zero);
    for (label o = bodies.size(); o < bodies.nHeld(); ++o)
    {
        if (bodies.movesFreely(o))
        {
            const label start = surfaces.pointStart()[o];
            const label end = surfaces.pointStart()[o + 1];
            SubList<vector>(force, end - start, start) = vector(Zero);
        }
    }
    bodies.ranks().collect({objectRanks::values::ofNodes(force)});
}


// ************************************************************************* //
