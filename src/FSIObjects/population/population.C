// SPDX-License-Identifier: GPL-3.0-or-later

#include "population.H"
#include "openfoamVersion.H"
#include "SubField.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::population::renumber()
{
    groupStart_.resize(groups_.size() + 1);
    groupStart_ = 0;
    forAll(groups(), groupi)
    {
        groupStart_[groupi + 1] = groupStart_[groupi] + groups()[groupi].size();
    }

    objectGroup_.resize(groupStart_.last());
    indexOfId_.clear();
    surfaces_.clear();
    layout_.clear();
    forAll(groups(), groupi)
    {
        const shapeTemplate& s = groups_.shape(groupi);
        layout_.append(s.nNodes(), s.nBoundaryNodes(), groups()[groupi].size());
        pointField boundary
        (
            SubField<point>(s.points(), s.nBoundaryNodes())
        );
        if (nDims_ == 2)
        {
            boundary.replace(vector::Z, planeZ_);
        }
        const labelList& ids = groups()[groupi].objectIds();
        label objecti = surfaces_.append(boundary, s.faces(), ids.size());
        for (const label id : ids)
        {
            indexOfId_.insert(id, objecti);
            surfaces_.setFixed(objecti, groups_.stays(groupi));
            surfaces_.setImmersed(objecti, !groups()[groupi].hasWalls());
            ++objecti;
        }
        SubList<label>
        (
            objectGroup_, groups()[groupi].size(), groupStart_[groupi]
        ) = groupi;
    }

    updateSurfaces();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::population::population(const Time& time)
:
    population(time, 2, 0)
{
    readCounters();
    surfaces_ = surfaceSet(nDims_);
    layout_ = nodeLayout(nDims_);
    groups_.read(nDims_, nextObjectId_);
    renumber();
    checkPeriods();
}


Foam::fsi::population::population
(
    const Time& time,
    const direction nDims,
    const scalar planeZ
)
:
    time_(time),
    nDims_(nDims),
    planeZ_(planeZ),
    nextObjectId_(0),
    groups_(time),
    groupStart_(1, Zero),
    surfaces_(nDims),
    layout_(nDims)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::population::movesFreely(const label objecti) const
{
    return groups()[objectGroup_[objecti]].movesFreely();
}


void Foam::fsi::population::updateSurfaces()
{
    nodeLayout::groupNodal values(groups_.size());
    forAll(groups(), groupi)
    {
        values[groupi] = groups()[groupi].velocities();
    }
    layout_.toSurface(values, surfaces_.velocities());
    forAll(groups(), groupi)
    {
        values[groupi] = groups()[groupi].positions();
    }
    layout_.toSurface(values, surfaces_.points());
    if (nDims_ == 2)
    {
        surfaces_.points().replace(vector::Z, planeZ_);
    }
}


Foam::label Foam::fsi::population::objectId(const label objecti) const
{
    return groups()[objectGroup_[objecti]].objectIds()[objectCopy(objecti)];
}


void Foam::fsi::population::wrap(const periodicImages& images)
{
    forAll(groups(), groupi)
    {
        // Bodies that are fixed stay where they were put, and may reach out on
        // both sides; a step of second order ends where it started from
        if (groups_.stays(groupi) || groups()[groupi].secondOrder())
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
            for (direction d = 0; d < nDims_; ++d)
            {
                group.positions().col(nDims_*copyi + d).array() -=
                    n[d]*images.period()[d];
            }
            const label objectId = group.objectIds()[copyi];
            periods_.set
            (
                objectId, valueOr(periods_, objectId, labelVector::zero) + n
            );
        }
    }
}


Foam::labelVector Foam::fsi::population::periods(const label objecti) const
{
    return valueOr(periods_, objectId(objecti), labelVector::zero);
}


Foam::label Foam::fsi::population::addShape
(
    autoPtr<shapeTemplate> shape,
    const dictionary& motion
)
{
    const label groupi = groups_.append(shape, motion);
    renumber();
    return groupi;
}


Foam::label Foam::fsi::population::append
(
    const label groupi,
    const point& centre,
    const tensor& rotation,
    const vector& velocity,
    const vector& angularVelocity
)
{
    return append
    (
        labelList(1, groupi),
        pointField(1, centre),
        tensorField(1, rotation),
        vectorField(1, velocity),
        vectorField(1, angularVelocity)
    ).first();
}


Foam::labelList Foam::fsi::population::append
(
    const labelList& groups,
    const pointField& centres,
    const tensorField& rotations,
    const vectorField& velocities,
    const vectorField& angularVelocities
)
{
    labelList next(groups_.size());
    forAll(next, groupi)
    {
        const auto added = std::count(groups.begin(), groups.end(), groupi);
        next[groupi] = this->groups()[groupi].size();
        this->groups()[groupi].resize(next[groupi] + added);
    }
    labelList ids(groups.size());
    forAll(groups, i)
    {
        ids[i] = nextObjectId_++;
        this->groups()[groups[i]].append
        (
            centres[i],
            rotations[i],
            velocities[i],
            angularVelocities[i],
            ids[i],
            next[groups[i]]++
        );
    }
    renumber();
    return ids;
}


void Foam::fsi::population::remove(const labelList& objects)
{
    // From behind, so that the indices of those before stay valid
    labelList descending(objects);
    sort(descending, std::greater<label>());
    for (const label objecti : descending)
    {
        periods_.erase(objectId(objecti));
        groups()[objectGroup_[objecti]].remove(objectCopy(objecti));
    }
    renumber();
}


// ************************************************************************* //
