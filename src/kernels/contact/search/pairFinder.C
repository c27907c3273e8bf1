// SPDX-License-Identifier: GPL-3.0-or-later

#include "pairFinder.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::pairFinder::pairFinder
(
    const dictionary& dict,
    periodicImages& images
)
:
    search_(contactSearch::New(dict)),
    images_(images)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::pairFinder::find
(
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis,
    const scalar range,
    contactPairs& found,
    const scalarField& reaches
)
{
    if (!periodicImages::anyWalls(surfaces))
    {
        // Membranes inside the fluid do not touch
        found.clear();
        return;
    }
    const surfaceSet& all = images_.update(surfaces, range);
    scalarField reachesOfAll(reaches.empty() ? 0 : all.size());
    forAll(reachesOfAll, objecti)
    {
        reachesOfAll[objecti] = reaches[all.original(objecti)];
    }
    search_->setReaches(reachesOfAll);
    search_->find(all, walls, medialAxis, range, found);

    // Originals find with other images all that images' nodes find. Between
    // walls and objects that are moved as prescribed nothing can act, and what
    // acts between guests is the business of others
    label n = 0;
    for (const contactPair& pair : found.pairs)
    {
        if (all.originalNode(pair.node) != pair.node)
        {
            continue;
        }
        contactPair& kept = found.pairs[n];
        kept = pair;
        if (pair.face >= 0)
        {
            kept.other = pair.wall < 0 ? all.original(pair.other) : pair.other;
            kept.face = all.originalFace(pair.face);
        }
        const auto pushed = [&](const label objecti)
        {
            return !bodies[objecti].prescribed && !bodies[objecti].guest;
        };
        n +=
            kept.other >= 0
          ? pushed(surfaces.pointObject()[kept.node]) || pushed(kept.other)
          : pushed(surfaces.pointObject()[kept.node])
         && !bodies.sheltered(kept.node);
    }
    found.pairs.resize(n);
}


// ************************************************************************* //
