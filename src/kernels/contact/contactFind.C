// SPDX-License-Identifier: GPL-3.0-or-later

#include "contact.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contact::find
(
    contactSearch& search,
    const surfaceSet& surfaces,
    const contactBodies& bodies,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>& medialAxis,
    const scalar range,
    contactPairs& found
)
{
    const surfaceSet& all = images_.update(surfaces, range);
    search.find(all, walls, medialAxis, range, found);

    // What images' nodes find their originals find with other images. Between
    // walls and objects that are moved as prescribed nothing can act, nor
    // within a rigid object
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
            kept.other = all.original(pair.other);
            kept.face = all.originalFace(pair.face);
        }
        const label own = surfaces.pointObject()[kept.node];
        const bool within = kept.other == own && kept.face >= 0;
        const bool acts =
            !bodies[own].prescribed
         || (kept.other >= 0 && !bodies[kept.other].prescribed);
        n += acts && !(within && bodies[own].keepsShape);
    }
    found.pairs.resize(n);
}


void Foam::fsi::contact::count(const surfaceSet& surfaces)
{
    statistics_.contacts = 0;
    statistics_.smallestGap = GREAT;
    statistics_.potentialEnergy = 0;
    statistics_.sweeps = 0;
    statistics_.objectContacts.setSize(surfaces.size());
    statistics_.objectContacts = 0;
    statistics_.objectGaps.setSize(surfaces.size());
    statistics_.objectGaps = GREAT;
    touching_.clear();

    for (const contactPair& pair : found_.pairs)
    {
        const label own = surfaces.pointObject()[pair.node];
        scalar& ownGap = statistics_.objectGaps[own];
        ownGap = min(ownGap, pair.gap);
        if (pair.other >= 0)
        {
            scalar& otherGap = statistics_.objectGaps[pair.other];
            otherGap = min(otherGap, pair.gap);
        }
        statistics_.smallestGap = min(statistics_.smallestGap, pair.gap);
        if (pair.gap < scales_.range)
        {
            touching_.append
            (
                labelPair(min(own, pair.other), max(own, pair.other))
            );
        }
    }

    std::sort(touching_.begin(), touching_.end());
    const auto end = std::unique(touching_.begin(), touching_.end());
    for (auto touch = touching_.begin(); touch != end; ++touch)
    {
        ++statistics_.contacts;
        ++statistics_.objectContacts[touch->second()];
        if (touch->first() >= 0)
        {
            ++statistics_.objectContacts[touch->first()];
        }
    }
}


bool Foam::fsi::contact::mayClose
(
    const surfaceSet& surfaces,
    const vectorField& v,
    const scalar dt
) const
{
    if (needsMedialAxis() || !searched(surfaces))
    {
        return true;
    }

    // Mean velocity of each object, and how far its nodes' are from it
    vectorField mean(surfaces.size(), Zero);
    scalarField spread(surfaces.size(), Zero);
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label end = surfaces.pointStart()[objecti + 1];
        for (label nodei = start; nodei < end; ++nodei)
        {
            mean[objecti] += v[nodei]/(end - start);
        }
        for (label nodei = start; nodei < end; ++nodei)
        {
            spread[objecti] =
                max(spread[objecti], mag(v[nodei] - mean[objecti]));
        }
    }

    // A pair has the nearest point of the other object, and all of that object
    // comes nearer by this speed at most
    for (const contactPair& pair : found_.pairs)
    {
        const scalar approach =
            pair.other < 0
          ? -(v[pair.node] & pair.normal)
          : mag(v[pair.node] - mean[pair.other]) + spread[pair.other];
        if (pair.gap - dt*approach < minimumGap_)
        {
            return true;
        }
    }
    return false;
}


// ************************************************************************* //
