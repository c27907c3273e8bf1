// SPDX-License-Identifier: GPL-3.0-or-later

#include "heldObjects.H"
#include "SubField.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::heldObjects::appendSurfaces
(
    const label groupi,
    const label first,
    const label end
)
{
    const shapeTemplate& s = groups_.shape(groupi);
    pointField boundary(s.boundaryPoints());
    if (nDims_ == 2)
    {
        boundary.replace(vector::Z, planeZ_);
    }
    surfaces_.append(boundary, s.faces(), end - first);
    for (label objecti = first; objecti < end; ++objecti)
    {
        indexOfId_.insert(objectId(objecti), objecti);
        surfaces_.setKey(objecti, keys_[objecti]);
        surfaces_.setFixed(objecti, groups_.stays(groupi));
        surfaces_.setImmersed(objecti, !groups()[groupi].hasWalls());
    }
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::heldObjects::setDirections(const direction nDims)
{
    nDims_ = nDims;
    surfaces_ = surfaceSet(nDims);
    layout_ = nodeLayout(nDims);
}


void Foam::fsi::heldObjects::renumber()
{
    renumber(findGuests());
    updateSurfaces();
    nCopies_.setSize(groups_.size());
    forAll(nCopies_, groupi)
    {
        nCopies_[groupi] = groups()[groupi].size();
    }
    if (!ranks_.shared())
    {
        sumOverRanks(nCopies_);
    }
}


Foam::List<Foam::labelPair> Foam::fsi::heldObjects::findGuests()
{
    if (ranks_.shared())
    {
        return List<labelPair>();
    }
    DynamicList<boundBox> boxes;
    DynamicList<labelPair> keys;
    forAll(groups(), groupi)
    {
        const bodyGroup& group = groups()[groupi];
        const label nB = group.shape().nBoundaryNodes();
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            boundBox box(point(0, 0, planeZ_), point(0, 0, planeZ_));
            for (direction d = 0; d < nDims_; ++d)
            {
                const auto x = group.positions().col(nDims_*copyi + d).head(nB);
                box.min()[d] = x.minCoeff();
                box.max()[d] = x.maxCoeff();
            }
            boxes.append(box);
            keys.append(labelPair(groupi, group.objectIds()[copyi]));
        }
    }
    return ranks_.findHolders(boxes, keys);
}


void Foam::fsi::heldObjects::renumber(const List<labelPair>& guests)
{
    groupStart_.resize(groups_.size() + 1);
    groupStart_ = 0;
    DynamicList<labelPair> keys;
    forAll(groups(), groupi)
    {
        for (const label id : groups()[groupi].objectIds())
        {
            keys.append(labelPair(groupi, id));
        }
        groupStart_[groupi + 1] = keys.size();
    }
    keys.append(guests);
    keys_ = keys;

    indexOfId_.clear();
    surfaces_.clear();
    layout_.clear();
    for (label objecti = 0; objecti < keys_.size();)
    {
        const label groupi = objectGroup(objecti);
        const bool own = objecti < size();
        label end = objecti + 1;
        while
        (
            end < keys_.size() && objectGroup(end) == groupi
         && (end < size()) == own
        )
        {
            ++end;
        }
        appendSurfaces(groupi, objecti, end);
        objecti = end;
    }
    forAll(groups(), groupi)
    {
        const shapeTemplate& s = groups_.shape(groupi);
        layout_.append(s.nNodes(), s.nBoundaryNodes(), groups()[groupi].size());
    }
    if (!ranks_.shared())
    {
        ranks_.setNodes(surfaces_);
        layout_.appendGuests
        (
            surfaces_.pointStart().last() - surfaces_.pointStart()[size()],
            ranks_
        );
    }
}


void Foam::fsi::heldObjects::removeCopies(const labelUList& objects)
{
    List<DynamicList<label>> copies(groups_.size());
    for (const label objecti : objects)
    {
        copies[objectGroup(objecti)].append(objectCopy(objecti));
    }
    forAll(copies, groupi)
    {
        groups()[groupi].remove(copies[groupi]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::heldObjects::heldObjects
(
    const Time& time,
    const direction nDims,
    const scalar planeZ
)
:
    groupStart_(1, Zero),
    surfaces_(nDims),
    layout_(nDims),
    nDims_(nDims),
    planeZ_(planeZ),
    groups_(time)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::heldObjects::movesFreely(const label objecti) const
{
    return groups()[objectGroup(objecti)].movesFreely();
}


bool Foam::fsi::heldObjects::stepRuns() const
{
    return groups().size() && groups().first().secondOrder();
}


void Foam::fsi::heldObjects::updateSurfaces()
{
    nodeLayout::groupNodal values(groups_.size());
    forAll(groups(), groupi)
    {
        values[groupi] = groups()[groupi].velocities();
    }
    layout_.toSurface(values, surfaces_.velocities(), false);
    forAll(groups(), groupi)
    {
        values[groupi] = groups()[groupi].positions();
    }
    layout_.toSurface(values, surfaces_.points(), false);
    if (nDims_ == 2)
    {
        surfaces_.points().replace(vector::Z, planeZ_);
    }
    ranks_.spread
    ({
        objectRanks::values::ofWalls(surfaces_.velocities()),
        objectRanks::values::ofNodes(surfaces_.points())
    });
}


void Foam::fsi::heldObjects::wrap(const periodicImages& images)
{
    forAll(groups(), groupi)
    {
        // Bodies that are fixed stay where they were put, and may reach out on
        // both sides; a step of second order ends where it started from
        if (groups_.stays(groupi) || stepRuns())
        {
            continue;
        }
        bodyGroup& group = groups()[groupi];
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            const labelVector n =
                images.periodsOutside(group.centroid(copyi));
            if (n == labelVector::zero)
            {
                continue;
            }
            group.moveBack(copyi, n, images.period());
        }
    }
}


// ************************************************************************* //
