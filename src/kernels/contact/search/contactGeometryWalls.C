// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactGeometry.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::contactGeometry::appendWalls
(
    const point& x,
    const label nodei,
    const UList<contactWall>& walls,
    const scalar range,
    DynamicList<contactPair>& pairs
)
{
    forAll(walls, walli)
    {
        vector away;
        const scalar gap = walls[walli].gap(x, away);
        if (gap < range)
        {
            contactPair p;
            p.node = nodei;
            p.face = -1;
            p.wall = walli;
            p.other = -1 - walli;
            p.weights = 0.0;
            p.gap = gap;
            p.normal = away;
            pairs.append(p);
        }
    }
}


void Foam::fsi::contactGeometry::appendRims
(
    const surfaceSet& surfaces,
    const label objecti,
    const UList<contactWall>& walls,
    const scalar range,
    DynamicList<contactPair>& pairs
)
{
    boundBox near(surfaces.bounds(objecti));
    near.min() -= range*vector::one;
    near.max() += range*vector::one;
    forAll(walls, walli)
    {
        for (point x : walls[walli].rim())
        {
            if (surfaces.nDims() == 2)
            {
                x.z() = surfaces.points()[surfaces.pointStart()[objecti]].z();
            }
            if (!near.contains(x))
            {
                continue;
            }
            const label start = surfaces.faceStart()[objecti];
            const label end = surfaces.faceStart()[objecti + 1];
            for (label facei = start; facei < end; ++facei)
            {
                const nearestFace place(nearestOn(surfaces, facei, x));
                if (magSqr(place.offset) <= sqr(range))
                {
                    keep(surfaces, place);
                }
            }
            for (const nearestFace& nearest : nearest_)
            {
                contactPair p(pair(surfaces, x, -1, nearest));
                const label i = findMax(p.weights);
                p.node = surfaces.faces()[nearest.face][i];
                p.wall = walli;
                p.other = -1 - walli;
                for (scalar& weight : p.weights)
                {
                    weight = -weight;
                }
                p.weights[i] += 1;
                p.normal = -p.normal;
                pairs.append(p);
            }
            nearest_.clear();
        }
    }
}


// ************************************************************************* //
