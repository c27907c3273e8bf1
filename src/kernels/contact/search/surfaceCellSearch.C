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

    //- Nodes that are tried together
    static const label groupSize = 5;

    //- Most cubes beside each other that a group may lie in
    static const label maxCubes = 4;

    //- Largest whole number up to x; std::floor is a call
    static long below(const scalar x)
    {
        const long i = long(x);
        return i - (x < i);
    }

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
    return {below(p.x()/side_), below(p.y()/side_), below(p.z()/side_)};
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


template<class Action>
bool Foam::fsi::surfaceCellSearch::anyInRow
(
    const label firstSlot,
    const label nCubes,
    const Action& action
) const
{
    // Cubes side by side have slots side by side, or go on at the table's
    // begin
    const label nSlots = start_.size() - 1;
    const label endSlot = min(firstSlot + nCubes, nSlots);
    const label nBegin = start_[firstSlot + nCubes - endSlot];
    for (label i = start_[firstSlot]; i < start_[endSlot]; ++i)
    {
        if (action(i))
        {
            return true;
        }
    }
    for (label i = 0; i < nBegin; ++i)
    {
        if (action(i))
        {
            return true;
        }
    }
    return false;
}


bool Foam::fsi::surfaceCellSearch::mayPair
(
    const surfaceSet& surfaces,
    const label begin,
    const label end
) const
{
    nodeGroup nodes(surfaces.pointObject()[begin]);
    for (label nodei = begin; nodei < end; ++nodei)
    {
        geometry_.addTo(nodes, surfaces, nodei);
    }
    const cube first = cubeOf(nodes.places().min());
    const cube last = cubeOf(nodes.places().max());
    for (direction d = 0; d < 3; ++d)
    {
        if (last[d] - first[d] >= maxCubes)
        {
            return true;
        }
    }

    const label nz = surfaces.nDims() == 3 ? 1 : 0;
    const label width = last[0] - first[0] + 3;
    bool any = width >= start_.size();
    for (long k = first[2] - nz; k <= last[2] + nz && !any; ++k)
    {
        for (long j = first[1] - 1; j <= last[1] + 1 && !any; ++j)
        {
            any = anyInRow(slot(first[0] - 1, j, k), width, [&](const label i)
            {
                return nodes.mayPair
                (
                    objects_[i],
                    geometry_.faceNormal(faces_[i]),
                    centres_[i],
                    reach_,
                    geometry_.selfContact()
                );
            });
        }
    }
    return any;
}


void Foam::fsi::surfaceCellSearch::visit
(
    const surfaceSet& surfaces,
    const label nodei,
    const scalar range
)
{
    const label own =
        geometry_.selfContact() ? -1 : surfaces.pointObject()[nodei];
    const point& x = surfaces.points()[nodei];
    const cube c = cubeOf(x);
    const label nz = surfaces.nDims() == 3 ? 1 : 0;
    for (long k = c[2] - nz; k <= c[2] + nz; ++k)
    {
        for (long j = c[1] - 1; j <= c[1] + 1; ++j)
        {
            anyInRow(slot(c[0] - 1, j, k), 3, [&](const label i)
            {
                if (objects_[i] != own && magSqr(centres_[i] - x) < sqr(reach_))
                {
                    geometry_.consider(surfaces, nodei, faces_[i], range);
                }
                return false;
            });
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

    const pointField& x = surfaces.points();
    const labelList& pointStart = surfaces.pointStart();
    for (label objecti = 0; objecti < surfaces.size(); ++objecti)
    {
        const label endNode = pointStart[objecti + 1];
        bool near = false;
        for (label nodei = pointStart[objecti]; nodei < endNode; ++nodei)
        {
            if ((nodei - pointStart[objecti]) % groupSize == 0)
            {
                const label end = min(nodei + groupSize, endNode);
                near = mayPair(surfaces, nodei, end);
            }
            if (near)
            {
                visit(surfaces, nodei, range);
                geometry_.append(surfaces, nodei, found.pairs);
            }
            contactGeometry::appendWalls
            (
                x[nodei], nodei, walls, range, found.pairs
            );
        }
    }
}


// ************************************************************************* //
