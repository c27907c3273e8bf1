// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneGaps.H"
#include "boxPairs.H"
#include "surfaceWinding.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::membraneGaps::findNear
(
    const surfaceSet& surfaces,
    const label nObjects,
    const scalar range
)
{
    List<boundBox> boxes(surfaces.size());
    forAll(boxes, objecti)
    {
        boxes[objecti] = surfaces.bounds(objecti);
        boxes[objecti].min() -= 0.5*range*vector::one;
        boxes[objecti].max() += 0.5*range*vector::one;
    }
    near_.setSize(surfaces.size());
    for (DynamicList<neighbour>& ofObject : near_)
    {
        ofObject.clear();
    }
    const auto visit = [&](const label a, const label b, const vector& shift)
    {
        if (a < nObjects && !surfaces.hasWalls(b))
        {
            near_[b].append(neighbour{a, shift});
        }
    };
    for (const boxPair& p : boxPairs(boxes, period_, surfaces.nDims()))
    {
        visit(p.first, p.second, p.shift);
        visit(p.second, p.first, -p.shift);
    }
}


inline Foam::label Foam::fsi::membraneGaps::binAt
(
    const scalar x,
    const direction d
) const
{
    const label i = label((x - box_.min()[d])*perSize_);
    return min(max(i, label(0)), nBins_[d] - 1);
}


void Foam::fsi::membraneGaps::sortVisitors
(
    const surfaceSet& surfaces,
    const label objecti,
    const scalar range
)
{
    box_ = surfaces.bounds(objecti);
    box_.min() -= range*vector::one;
    box_.max() += range*vector::one;
    for (direction d = 0; d < 3; ++d)
    {
        nBins_[d] = label((box_.max()[d] - box_.min()[d])*perSize_) + 1;
    }
    bins_.setSize(nBins_[0]*nBins_[1]*nBins_[2]);
    bins_ = -1;
    visitors_.clear();
    visitorBox_ = boundBox(vector::max, vector::min);
    for (const neighbour& near : near_[objecti])
    {
        const label end = surfaces.pointStart()[near.object + 1];
        for (label i = surfaces.pointStart()[near.object]; i < end; ++i)
        {
            const point x(surfaces.points()[i] + near.shift);
            if (box_.contains(x))
            {
                const label bin =
                    binAt(x.x(), 0)
                  + nBins_[0]*(binAt(x.y(), 1) + nBins_[1]*binAt(x.z(), 2));
                visitors_.append(visitor{i, x, bins_[bin], -1});
                bins_[bin] = visitors_.size() - 1;
                visitorBox_.min() = min(visitorBox_.min(), x);
                visitorBox_.max() = max(visitorBox_.max(), x);
            }
        }
    }
}


void Foam::fsi::membraneGaps::look
(
    const surfaceSet& surfaces,
    const label facei,
    const scalar range
)
{
    const surfaceFace& f = surfaces.faces()[facei];
    point low(surfaces.points()[f[0]]), high(low);
    for (label i = 1; i < surfaces.nNodes(); ++i)
    {
        low = min(low, surfaces.points()[f[i]]);
        high = max(high, surfaces.points()[f[i]]);
    }
    const boundBox around(low - range*vector::one, high + range*vector::one);
    if (!around.overlaps(visitorBox_))
    {
        return;
    }
    FixedList<label, 3> first, last;
    for (direction d = 0; d < 3; ++d)
    {
        first[d] = binAt(around.min()[d], d);
        last[d] = binAt(around.max()[d], d);
    }
    for (label k = first[2]; k <= last[2]; ++k)
    {
        for (label j = first[1]; j <= last[1]; ++j)
        {
            const label row = nBins_[0]*(j + nBins_[1]*k);
            for (label i = first[0]; i <= last[0]; ++i)
            {
                for (label n = bins_[row + i]; n >= 0; n = visitors_[n].next)
                {
                    if (around.contains(visitors_[n].x))
                    {
                        see(surfaces, facei, visitors_[n], range);
                    }
                }
            }
        }
    }
}


void Foam::fsi::membraneGaps::see
(
    const surfaceSet& surfaces,
    const label facei,
    visitor& v,
    const scalar range
)
{
    FixedList<scalar, 3> weights;
    const vector away(v.x - surfaces.nearestOnFace(facei, v.x, weights));
    const scalar gap = mag(away);
    const scalar nearest = v.pair < 0 ? range : pairs_[v.pair].gap;
    if (gap > nearest*(1 + 1e-9))
    {
        return;
    }
    const vector area(surfaces.areaNormal(facei));
    const vector normal(area/max(mag(area), VSMALL));
    if (v.pair >= 0 && gap > nearest*(1 - 1e-9))
    {
        // The place is on an edge or at a node
        pairs_[v.pair].normal += normal;
        return;
    }
    if (v.pair < 0)
    {
        v.pair = pairs_.size();
        pairs_.append(pair());
        away_.append(vector::zero);
    }
    pairs_[v.pair] = pair
    {
        v.node,
        facei,
        weights,
        gap,
        normal,
        surfaces.hasWalls(surfaces.pointObject()[v.node])
    };
    away_[v.pair] = away;
}


void Foam::fsi::membraneGaps::finish(const surfaceSet& surfaces)
{
    forAll(pairs_, pairi)
    {
        pair& p = pairs_[pairi];
        const vector outward(p.normal/max(mag(p.normal), VSMALL));
        const auto isInside = [&]
        {
            const point place
            (
                surfaces.interpolate(surfaces.points(), p.face, p.weights)
            );
            return contains
            (
                surfaces, surfaces.faceObject()[p.face], place + away_[pairi]
            );
        };
        const bool inside = (away_[pairi] & outward) < 0 && isInside();
        p.normal =
            p.gap > 1e-6*size_
          ? (inside ? -1 : 1)*away_[pairi]/p.gap
          : outward;
        p.gap *= inside ? -1 : 1;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneGaps::find
(
    const surfaceSet& surfaces,
    const label nObjects,
    const scalar range
)
{
    pairs_.clear();
    away_.clear();
    findNear(surfaces, nObjects, range);
    forAll(near_, objecti)
    {
        if (near_[objecti].empty())
        {
            continue;
        }
        sortVisitors(surfaces, objecti, range);
        const label end = surfaces.faceStart()[objecti + 1];
        label facei = surfaces.faceStart()[objecti];
        for (; facei < end && visitors_.size(); ++facei)
        {
            look(surfaces, facei, range);
        }
    }
    finish(surfaces);
}


// ************************************************************************* //
