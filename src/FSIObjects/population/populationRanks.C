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


void Foam::fsi::population::gatherCopies
(
    const label groupi,
    const bool onAll,
    bodyGroup& group
) const
{
    const bodyGroup& part = groups()[groupi];
    copyValues mine;
    for (label copyi = 0; copyi < part.size(); ++copyi)
    {
        part.take(copyi, mine);
    }
    group.setHistory(part.history());
    copyValues values(ranks_.gathered(scalarList(mine.values()), onAll));
    group.resize(values.more() ? nCopies(groupi) : 0);
    for (label copyi = 0; copyi < group.size(); ++copyi)
    {
        group.exchange(copyi, values);
    }
    group.sort();
}


void Foam::fsi::population::read(const cellOwners& cells)
{
    cells_ = cells;
    readCounters();
    groups_.read(nDims_, nextObjectId_, cells_);
    if (nRanksIn() > 1)
    {
        ranks_.share(reachBoxes());
    }
    renumber();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::population::share(const scalar distance)
{
    if (!ranks_.shared())
    {
        ranks_.share(cells_.reach(distance));
        renumber();
    }
}


void Foam::fsi::population::holdAll()
{
    if (ranks_.shared())
    {
        return;
    }
    forAll(groups(), groupi)
    {
        gatherCopies(groupi, true, groups()[groupi]);
    }
    ranks_ = objectRanks();
    renumber();
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
        gatherCopies(groupi, false, all.groups()[groupi]);
    }
    all.renumber();
    return all;
}


// ************************************************************************* //
