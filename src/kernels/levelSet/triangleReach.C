// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangleReach.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Margin that is added for round-off, over the width
static const scalar margin = 1e-3;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::triangleReach::add
(
    part& p,
    label& nLimits,
    const vector& g,
    const scalar c
) const
{
    // A side along x limits y and z: any x, or none
    const scalar perG = 1/(mag(g.x()) > ROOTVSMALL ? g.x() : ROOTVSMALL);
    const limit l({a_.x() + c*perG, -g.y()*perG, -g.z()*perG});
    if (perG < 0)
    {
        p.limits[nLimits++] = p.limits[p.nLower];
        p.limits[p.nLower++] = l;
    }
    else
    {
        p.limits[nLimits++] = l;
    }
}


void Foam::fsi::triangleReach::setBounds
(
    const FixedList<point, 3>& corners,
    const surfaceFace& f,
    const normalCones& cones,
    const scalar width
)
{
    vector reach(Zero);
    for (const label nodei : f)
    {
        const vector tangent(vector::uniform(cones.tangent(nodei)));
        reach = max(reach, cmptMag(cones.axis(nodei)) + tangent);
    }
    reach = width*(min(reach, vector::one) + vector::uniform(margin));
    bounds_ = boundBox
    (
        min(min(corners[0], corners[1]), corners[2]) - reach,
        max(max(corners[0], corners[1]), corners[2]) + reach
    );
}


Foam::FixedList<Foam::scalar, 2> Foam::fsi::triangleReach::slopes
(
    const surfaceFace& f,
    const vector& normal,
    const vector& leaving,
    const FixedList<scalar, 3>& heights,
    const normalCones& cones
)
{
    FixedList<scalar, 2> slope(0.0);
    forAll(f, i)
    {
        const scalar tangent = cones.tangent(f[i]);
        if (tangent >= normalCones::wide)
        {
            return FixedList<scalar, 2>(GREAT);
        }
        const vector& axis = cones.axis(f[i]);
        const scalar perRise = 1/((axis & normal) - sqr(tangent));
        const scalar aside = axis & leaving;
        slope[0] = max(slope[0], (tangent + aside)*perRise - heights[i]);
        slope[1] = max(slope[1], (tangent - aside)*perRise - heights[i]);
    }
    return slope;
}


void Foam::fsi::triangleReach::addSides
(
    const FixedList<point, 3>& corners,
    const surfaceFace& f,
    const vector& normal,
    const normalCones& cones,
    const scalar width
)
{
    const scalar extra = margin*width;
    label nLimits[2] = {0, 0};
    for (label side = 0; side < 2; ++side)
    {
        const vector up(side == 0 ? normal : -normal);
        add(parts_[side], nLimits[side], -up, extra);
        add(parts_[side], nLimits[side], up, width + extra);
    }

    for (label edge = 0; edge < 3; ++edge)
    {
        const vector along(corners[(edge + 1) % 3] - corners[edge]);
        const scalar perLength = 1/mag(along);
        const vector leaving(perLength*(along ^ normal));
        const vector e(corners[edge] - a_);

        // Height of the third node above the edge, over the width
        const label other = (edge + 2) % 3;
        FixedList<scalar, 3> heights(0.0);
        heights[other] = (leaving & (corners[edge] - corners[other]))/width;

        const FixedList<scalar, 2> slope
        (
            slopes(f, normal, leaving, heights, cones)
        );
        for (label side = 0; side < 2; ++side)
        {
            const bool upright = slope[side] > 1;
            const scalar lean = upright ? 0 : slope[side];
            add
            (
                parts_[side],
                nLimits[side],
                leaving - (side == 0 ? lean : -lean)*normal,
                (leaving & e) + extra + (upright ? width : 0)
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::triangleReach::triangleReach
(
    const surfaceSet& surfaces,
    const label facei,
    const normalCones& cones,
    const scalar width
)
{
    const surfaceFace& f = surfaces.faces()[facei];
    const FixedList<point, 3> corners
    ({
        surfaces.points()[f[0]],
        surfaces.points()[f[1]],
        surfaces.points()[f[2]]
    });
    a_ = corners[0];
    setBounds(corners, f, cones, width);

    const vector& normal = cones.normal(facei);
    for (part& p : parts_)
    {
        // All that the box holds
        p = part({{}, 0});
        for (limit& l : p.limits)
        {
            l = limit({GREAT, 0, 0});
        }
    }
    if (normal != vector::zero)
    {
        addSides(corners, f, normal, cones, width);
    }
}


// ************************************************************************* //
