// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearSurfaces.H"

#include <map>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Foam::fsi::closedSurface> Foam::fsi::nearSurfaces
(
    const population& objects,
    const boundBox& box
)
{
    const surfaceSet& surfaces = objects.surfaces();

    // Key and nodes of each, from its owner
    copyValues near;
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        if
        (
            closedSurface::near
            (
                surfaces.bounds(objecti), box, 0, surfaces.nDims()
            )
        )
        {
            label group = objects.objectGroup(objecti);
            label id = objects.objectId(objecti);
            near.number(group);
            near.number(id);
            const label end = surfaces.pointStart()[objecti + 1];
            for (label i = surfaces.pointStart()[objecti]; i < end; ++i)
            {
                point p(surfaces.points()[i]);
                near.vectorOf(p);
            }
        }
    }
    copyValues all(objects.ranks().gathered(scalarList(near.values())));
    std::map<labelPair, closedSurface> found;
    while (all.more())
    {
        labelPair key;
        all.number(key.first());
        all.number(key.second());
        const shapeTemplate& shape = objects.shape(key.first());
        pointField points(shape.nBoundaryNodes());
        for (point& p : points)
        {
            all.vectorOf(p);
        }
        found.emplace(key, closedSurface(points, shape.faces()));
    }
    std::vector<closedSurface> result;
    for (const auto& each : found)
    {
        result.push_back(each.second);
    }
    return result;
}


// ************************************************************************* //
