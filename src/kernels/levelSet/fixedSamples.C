// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixedSamples.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::fsi::fixedSamples::objects(const surfaceSet& surfaces)
{
    DynamicList<label> result;
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        if (surfaces.fixed(objecti))
        {
            result.append(objecti);
            result.append(surfaces.original(objecti));
            result.append(surfaces.faceStart()[objecti]);
        }
    }
    return labelList(result);
}


template<class Action>
bool Foam::fsi::fixedSamples::allNodes
(
    const surfaceSet& surfaces,
    const Action& action
)
{
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const label end =
            surfaces.fixed(objecti) ? surfaces.pointStart()[objecti + 1] : 0;
        for (label i = surfaces.pointStart()[objecti]; i < end; ++i)
        {
            if (!action(surfaces.points()[i]))
            {
                return false;
            }
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::fixedSamples::hold
(
    const surfaceSet& surfaces,
    const cartesianBlock& block
) const
{
    if
    (
        block.origin() != origin_
     || block.start() != start_
     || block.n() != n_
     || block.spacing() != spacing_
     || objects(surfaces) != objects_
    )
    {
        return false;
    }
    label n = 0;
    const bool same = allNodes(surfaces, [&](const point& p)
    {
        return n < points_.size() && p == points_[n++];
    });
    return same && n == points_.size();
}


void Foam::fsi::fixedSamples::keep
(
    const surfaceSet& surfaces,
    const cartesianBlock& block,
    const scalar farSqr,
    const FixedList<scalarField*, 2>& distancesSqr,
    const FixedList<labelList*, 3>& labels
)
{
    origin_ = block.origin();
    start_ = block.start();
    n_ = block.n();
    spacing_ = block.spacing();
    objects_ = objects(surfaces);
    DynamicList<point> points;
    allNodes(surfaces, [&](const point& p)
    {
        points.append(p);
        return true;
    });
    points_ = points;

    farSqr_ = farSqr;
    forAll(distancesSqr_, i)
    {
        distancesSqr_[i].clear();
        if (objects_.size())
        {
            distancesSqr_[i] = *distancesSqr[i];
        }
    }
    forAll(labels_, i)
    {
        labels_[i].clear();
        if (objects_.size())
        {
            labels_[i] = *labels[i];
        }
    }
}


void Foam::fsi::fixedSamples::copy
(
    const label begin,
    const label end,
    const FixedList<scalarField*, 2>& distancesSqr,
    const FixedList<labelList*, 3>& labels
) const
{
    const auto set = [&](const auto& from, auto& to, const auto& otherwise)
    {
        if (from.size())
        {
            std::copy
            (
                from.begin() + begin, from.begin() + end, to.begin() + begin
            );
        }
        else
        {
            std::fill(to.begin() + begin, to.begin() + end, otherwise);
        }
    };
    forAll(distancesSqr_, i)
    {
        set(distancesSqr_[i], *distancesSqr[i], farSqr_);
    }
    forAll(labels_, i)
    {
        set(labels_[i], *labels[i], label(-1));
    }
}


// ************************************************************************* //
