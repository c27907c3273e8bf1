// SPDX-License-Identifier: GPL-3.0-or-later

#include "population.H"
#include "latticeRanks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::population::population
(
    const Time& time,
    const cartesianMesh& grid
)
:
    population(time, 2, 0)
{
    read(cellOwners(grid));
}


Foam::fsi::population::population(const Time& time)
:
    population(time, 2, 0)
{
    read(cellOwners());
    holdAll();
}


Foam::fsi::population::population
(
    const Time& time,
    const direction nDims,
    const scalar planeZ
)
:
    heldObjects(time, nDims, planeZ),
    time_(time),
    nextObjectId_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    labelList ids(groups.size());
    const labelList owners
    (
        ranks_.shared()
      ? labelList(groups.size(), rankIn())
      : cells_.ranksAt(centres)
    );
    List<DynamicList<label>> mine(groups_.size());
    forAll(groups, i)
    {
        ids[i] = nextObjectId_++;
        if (owners[i] == rankIn())
        {
            mine[groups[i]].append(i);
        }
    }
    forAll(mine, groupi)
    {
        bodyGroup& group = this->groups()[groupi];
        label next = group.size();
        group.resize(next + mine[groupi].size());
        for (const label i : mine[groupi])
        {
            group.append
            (
                centres[i],
                rotations[i],
                velocities[i],
                angularVelocities[i],
                ids[i],
                next++
            );
        }
    }
    renumber();
    return ids;
}


void Foam::fsi::population::remove(const labelList& objects)
{
    removeCopies(objects);
    renumber();
}


// ************************************************************************* //
