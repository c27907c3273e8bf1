// SPDX-License-Identifier: GPL-3.0-or-later

#include "innerNodes.H"
#include "boundBox.H"
#include "ListOps.H"
#include "openfoamVersion.H"
#include "outlineTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Least distance of two nodes over the wanted one: points that keep it from
//  each other and leave no room are about the wanted distance apart
static const scalar leastDistance = 0.75;

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::fsi::innerNodes::lattice
(
    const scalar size,
    const vector& shift,
    const scalar from,
    const scalar to,
    scalarField& depths
) const
{
    const boundBox box(polygon_, false);
    const scalar rowHeight = 0.5*std::sqrt(3.0)*size;
    const label nRows = label(box.span().y()/rowHeight) + 2;
    const label nColumns = label(box.span().x()/size) + 2;

    DynamicList<point> points;
    DynamicList<scalar> found;
    for (label j = -1; j < nRows; ++j)
    {
        for (label i = -1; i < nColumns; ++i)
        {
            const point p
            (
                box.min().x() + size*(i + shift.x() + 0.5*(j & 1)),
                box.min().y() + rowHeight*(j + shift.y()),
                0
            );
            const scalar distance = outlineTools::distance(polygon_, p);
            const scalar depth =
                outlineTools::contains(polygon_, p) ? distance : -distance;
            if (depth > from && depth <= to)
            {
                points.append(p);
                found.append(depth);
            }
            else
            {
                // No point of the row is wanted up to there
                const scalar away = max(from - depth, depth - to);
                i += max(label(away/size) - 1, 0);
            }
        }
    }
    depths = std::move(found);
    return pointField(std::move(points));
}


Foam::label Foam::fsi::innerNodes::square
(
    const point& p,
    const label i,
    const label j
) const
{
    // Bodies are less than 2^15 spacings across
    const label x = label(std::floor(p.x()/spacing_)) + i;
    const label y = label(std::floor(p.y()/spacing_)) + j;
    return (x + 16384)*32768 + y + 16384;
}


void Foam::fsi::innerNodes::append(const point& p, const scalar depth)
{
    squares_(square(p, 0, 0)).append(points_.size());
    points_.append(p);
    sizes_.append(grading_.size(depth/spacing_));
}


bool Foam::fsi::innerNodes::near(const point& p, const scalar distance) const
{
    const label reach = label(distance/spacing_) + 1;
    for (label i = -reach; i <= reach; ++i)
    {
        for (label j = -reach; j <= reach; ++j)
        {
            const auto* found = findIn(squares_, square(p, i, j));
            if (!found)
            {
                continue;
            }
            for (const label pointi : *found)
            {
                if (magSqr(points_[pointi] - p) < sqr(distance))
                {
                    return true;
                }
            }
        }
    }
    return false;
}


void Foam::fsi::innerNodes::appendDeep
(
    const scalar clearance,
    const vector& shift
)
{
    const vector span(boundBox(polygon_, false).span());
    const scalar deepest = 0.5*min(span.x(), span.y())/spacing_;
    for (scalar least = 1; grading_.depth(least) < deepest; least *= 2)
    {
        scalarField depths;
        const pointField candidates
        (
            lattice
            (
                max(0.25*least, scalar(0.5))*spacing_,
                shift,
                max(grading_.depth(least)*spacing_, clearance),
                grading_.depth(2*least)*spacing_,
                depths
            )
        );
        for (const label i : orderOf(depths))
        {
            const scalar size = grading_.size(depths[i]/spacing_);
            if (!near(candidates[i], leastDistance*size*spacing_))
            {
                append(candidates[i], depths[i]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::innerNodes::innerNodes
(
    const pointField& polygon,
    const scalar spacing,
    const meshGrading& grading,
    const scalar clearance,
    const vector& shift
)
:
    polygon_(polygon),
    spacing_(spacing),
    grading_(grading)
{
    scalarField depths;
    const scalar even =
        grading.evenDepth() < GREAT ? grading.evenDepth()*spacing : GREAT;
    const pointField points
    (
        lattice(spacing, shift, clearance, even, depths)
    );
    forAll(points, i)
    {
        append(points[i], depths[i]);
    }
    if (even < GREAT)
    {
        appendDeep(clearance, shift);
    }
}


// ************************************************************************* //
