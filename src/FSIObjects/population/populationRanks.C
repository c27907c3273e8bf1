// SPDX-License-Identifier: GPL-3.0-or-later

#include "population.H"
#include "latticeRanks.H"
#include "objectMeans.H"
#include "objectMigration.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelListList Foam::fsi::population::leaving() const
{
    // Who has the place tells the owner; no one where the mesh has a hole
    const pointField centres(objectMeans(surfaces(), surfaces().points()));
    scalarField rank(nHeld(), Zero);
    forAll(rank, objecti)
    {
        rank[objecti] = cells_.here(centres[objecti]) ? rankIn() + 1 : 0;
    }
    ranks_.collect({objectRanks::values::ofObjects(rank)});

    List<DynamicList<label>> objects(nRanksIn());
    for (label objecti = 0; objecti < size(); ++objecti)
    {
        const label ranki = label(rank[objecti]) - 1;
        if (ranki >= 0 && ranki != rankIn())
        {
            objects[ranki].append(objecti);
        }
    }
    labelListList result(objects.size());
    forAll(result, ranki)
    {
        result[ranki] = objects[ranki];
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::population::share
(
    const cartesianMesh& grid,
    const scalar distance
)
{
    cells_ = cellOwners(grid);
    const labelList owners
    (
        cells_.ranksAt(objectMeans(surfaces(), surfaces().points()))
    );
    DynamicList<label> others;
    forAll(owners, objecti)
    {
        if (owners[objecti] != rankIn())
        {
            others.append(objecti);
        }
    }
    ranks_.share(cells_.reach(distance));
    remove(others);
}


bool Foam::fsi::population::migrate(const std::vector<vectorField*>& nodal)
{
    if (ranks_.shared())
    {
        return false;
    }
    objectMigration migration(*this, nodal, leaving());
    const List<labelPair> held(guests());
    removeCopies(migration.left());
    const bool moved = migration.append();
    const List<labelPair> near(findGuests());
    const bool changed = moved || near != held;
    if (changed)
    {
        renumber(near);
        migration.follow();
    }
    // Others may know what is owned here from now on
    updateSurfaces();
    return changed;
}


const Foam::fsi::population& Foam::fsi::population::whole
(
    autoPtr<population>& storage
) const
{
    if (ranks_.shared())
    {
        return *this;
    }
    storage.reset(new population(time_, nDims_, planeZ_));
    population& all = storage();
    all.nextObjectId_ = nextObjectId_;
    all.groups_.shareShapes(groups_);
    forAll(groups(), groupi)
    {
        const bodyGroup& part = groups()[groupi];
        bodyGroup& group = all.groups()[groupi];
        copyValues mine;
        for (label copyi = 0; copyi < part.size(); ++copyi)
        {
            part.take(copyi, mine);
        }
        group.beginLike(part);
        copyValues values(ranks_.gathered(scalarList(mine.values()), false));
        group.resize(values.more() ? nCopies(groupi) : 0);
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            group.exchange(copyi, values);
        }
        group.sort();
    }
    all.renumber();
    return all;
}


// ************************************************************************* //
