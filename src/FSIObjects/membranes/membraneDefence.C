// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneDefence.H"
#include "membraneGapLimit.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneDefence::membraneDefence
(
    const population& bodies,
    const vector& period,
    const scalar spacing,
    const scalar least
)
:
    bodies_(bodies),
    least_(least),
    reach_(least + 0.1*spacing),
    gaps_(period, spacing)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneDefence::limit
(
    const scalar deltaT,
    nodeLayout::groupNodal& v
)
{
    // Guests included: a rank has all pairs of the nodes that it owns
    const surfaceSet& surfaces = bodies_.surfaces();
    gaps_.find(surfaces, surfaces.size(), reach_);
    if (bodies_.ranks().largest(gaps_.pairs().size()) == 0)
    {
        return;
    }
    vectorField ofNodes;
    bodies_.layout().toSurface(v, ofNodes);
    const membraneGapLimit gapLimit
    (
        surfaces, gaps_.pairs(), deltaT, least_, ofNodes
    );
    vectorField changes(ofNodes);
    gapLimit.addChanges(ofNodes, changes);
    gapLimit.giveWay(changes);
    changes -= ofNodes;
    nodeLayout::groupNodal inGroups;
    bodies_.layout().toGroups(changes, inGroups);
    nodeLayout::add(inGroups, v);
}


// ************************************************************************* //
