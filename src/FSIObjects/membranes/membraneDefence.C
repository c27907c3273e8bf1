// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneDefence.H"

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
    const objectRanks& ranks = bodies_.ranks();
    gaps_.find(bodies_.surfaces(), bodies_.size(), reach_);
    if (ranks.largest(gaps_.pairs().size()) == 0)
    {
        return;
    }
    vectorField ofNodes;
    bodies_.layout().toSurface(v, ofNodes);
    vectorField changes(ofNodes.size()), sum(ofNodes.size(), Zero);
    for (label i = 0; i < nSweeps; ++i)
    {
        changes = Zero;
        gaps_.addChanges
        (
            bodies_.surfaces(), deltaT, least_, ofNodes, changes
        );
        if (!ranks.shared())
        {
            ranks.collect({objectRanks::values::ofNodes(changes)});
            ranks.spread({objectRanks::values::ofNodes(changes)});
        }
        ofNodes += changes;
        sum += changes;
    }
    nodeLayout::groupNodal inGroups;
    bodies_.layout().toGroups(sum, inGroups);
    nodeLayout::add(inGroups, v);
}


// ************************************************************************* //
