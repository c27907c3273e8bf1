// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceCellSearch.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(surfaceCellSearch, 0);
    addToRunTimeSelectionTable(contactSearch, surfaceCellSearch, dictionary);

    //- Mean of a face's nodes [m]
    static point centre(const surfaceSet& surfaces, const surfaceFace& f)
    {
        vector sum(Zero);
        for (label i = 0; i < surfaces.nNodes(); ++i)
        {
            sum += surfaces.points()[f[i]];
        }
        return sum/scalar(surfaces.nNodes());
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::surfaceCellSearch::surfaceCellSearch(const dictionary& dict)
:
    contactSearch(dict),
    side_(0),
    reach_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::surfaceCellSearch::cube
Foam::fsi::surfaceCellSearch::cubeOf(const point& p) const
{
    return
    {
        long(std::floor(p.x()/side_)),
        long(std::floor(p.y()/side_)),
        long(std::floor(p.z()/side_))
    };
}


void Foam::fsi::surfaceCellSearch::sort
(
    const surfaceSet& surfaces,
    const scalar range
)
{
    const List<surfaceFace>& faces = surfaces.faces();

    scalar radiusSqr = 0;
    for (const surfaceFace& f : faces)
    {
        const point c(centre(surfaces, f));
        for (label i = 0; i < surfaces.nNodes(); ++i)
        {
            radiusSqr = max(radiusSqr, magSqr(surfaces.points()[f[i]] - c));
        }
    }
    reach_ = range + sqrt(radiusSqr);
    side_ = reach_;

    // Counting sort: count, sum up, place from the back
    start_.setSize(2*faces.size() + 2);
    start_ = 0;
    slotOf_.setSize(faces.size());
    forAll(faces, facei)
    {
        const cube c = cubeOf(centre(surfaces, faces[facei]));
        slotOf_[facei] = slot(c[0], c[1], c[2]);
        ++start_[slotOf_[facei]];
    }
    for (label i = 1; i < start_.size(); ++i)
    {
        start_[i] += start_[i - 1];
    }
    centres_.setSize(faces.size());
    faces_.setSize(faces.size());
    objects_.setSize(faces.size());
    for (label facei = faces.size() - 1; facei >= 0; --facei)
    {
        const label sorted = --start_[slotOf_[facei]];
        faces_[sorted] = facei;
        objects_[sorted] = surfaces.faceObject()[facei];
        centres_[sorted] = centre(surfaces, faces[facei]);
    }
}


void Foam::fsi::surfaceCellSearch::visit
(
    const surfaceSet& surfaces,
    const label nodei,
    const label firstSlot,
    const label endSlot,
    const scalar range
)
{
    const label own =
        geometry_.selfContact() ? -1 : surfaces.pointObject()[nodei];
    const point& x = surfaces.points()[nodei];

    for (label i = start_[firstSlot]; i < start_[endSlot]; ++i)
    {
        if (objects_[i] != own && magSqr(centres_[i] - x) < sqr(reach_))
        {
            geometry_.consider(surfaces, nodei, faces_[i], range);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::surfaceCellSearch::find
(
    const surfaceSet& surfaces,
    const UList<contactWall>& walls,
    const UList<medialAxisPoint>&,
    const scalar range,
    contactPairs& found
)
{
    found.clear();
    geometry_.update(surfaces);
    sort(surfaces, range);

    const label nz = surfaces.nDims() == 3 ? 1 : 0;
    forAll(surfaces.points(), nodei)
    {
        const point& x = surfaces.points()[nodei];
        const cube c = cubeOf(x);
        for (long k = c[2] - nz; k <= c[2] + nz; ++k)
        {
            for (long j = c[1] - 1; j <= c[1] + 1; ++j)
            {
                // Three cubes side by side have slots side by side, or go on
                // at the table's begin
                const label nSlots = start_.size() - 1;
                const label sloti = slot(c[0] - 1, j, k);
                const label end = sloti + 3;
                visit(surfaces, nodei, sloti, min(end, nSlots), range);
                if (end > nSlots)
                {
                    visit(surfaces, nodei, 0, end - nSlots, range);
                }
            }
        }
        geometry_.append(surfaces, nodei, found.pairs);
        contactGeometry::appendWalls(x, nodei, walls, range, found.pairs);
    }
}


// ************************************************************************* //
