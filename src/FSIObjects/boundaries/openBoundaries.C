// SPDX-License-Identifier: GPL-3.0-or-later

#include "openBoundaries.H"
#include "errorOf.H"
#include "dictionaryCheck.H"
#include "openfoamMesh.H"
#include "openfoamVersion.H"
#include "stateFile.H"
#include "sumOverRanks.H"
#include "userVariables.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The one of some patches that is nearest to a point. All ranks must call
static const word& nearestPatch
(
    const polyBoundaryMesh& patches,
    const wordList& names,
    const point& p
)
{
    scalarField nearest(names.size(), GREAT);
    forAll(names, i)
    {
        const label patchi = patchOf(patches, names[i]);
        for (label j = 0; patchi >= 0 && j < patches[patchi].size(); ++j)
        {
            const scalar away = magSqr(patches[patchi].faceCentres()[j] - p);
            nearest[i] = min(nearest[i], away);
        }
    }
    combineOverRanks(nearest, minEqOp<scalar>());
    return names[findIndex(nearest, min(nearest))];
}

} // End namespace fsi
} // End namespace Foam

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::fsi::openBoundaries::state(const Time& time)
{
    const dictionary dict(readState(time, "fsiBoundaries"));
    checkKeys(dict, {"FoamFile", "removed", "feed"});
    return dict;
}


void Foam::fsi::openBoundaries::read()
{
    const dictionary dict(state(grid_.mesh().time()));
    if (dict.empty())
    {
        return;
    }
    removed_ = readEntry<labelList>(dict, "removed");
    const dictionary& feeds = dict.subOrEmptyDict("feed");
    for (objectFeed& feed : feeds_)
    {
        if (feeds.found(feed.patch()))
        {
            feed.read(feeds.subDict(feed.patch()));
        }
    }
}


Foam::label Foam::fsi::openBoundaries::sideLeft(const label objecti) const
{
    const boundBox box(objects_.surfaces().bounds(objecti));
    const bodyGroup& group = objects_.groups()[objects_.objectGroup(objecti)];
    for (label sidei = 0; sidei < 2*objects_.nDims(); ++sidei)
    {
        const scalar beyond = sides_.beyond(sidei, box);
        if (beyond <= 0)
        {
            continue;
        }
        if
        (
            sides_[sidei] == domainSides::WALL
         && sides_.behindWall(pointField(1, centreOf(box)))
        )
        {
            FatalErrorInFunction
                << "Object " << objects_.objectId(objecti) << " of shape "
                << group.shape().name() << ", from " << box.min() << " to "
                << box.max() << ", is wholly outside the domain "
                << sides_.bounds() << ", beyond a wall"
                << exit(FatalError);
        }
        const vector v(group.velocity(objects_.objectCopy(objecti)));
        if
        (
            beyond > grid_.spacing()
         && sides_.isOpen(sidei)
         && (v & domainSides::outward(sidei)) >= 0
        )
        {
            return sidei;
        }
    }
    return -1;
}


Foam::label Foam::fsi::openBoundaries::feedAt
(
    const label sidei,
    const point& p
) const
{
    forAll(feeds_, i)
    {
        if
        (
            findIndex(sides_.patches(sidei), feeds_[i].patch()) >= 0
         && feeds_[i].isBefore(p)
        )
        {
            return i;
        }
    }
    return -1;
}


void Foam::fsi::openBoundaries::warn(const label feedi)
{
    if (feedi >= 0)
    {
        ++nWarnings_;
        WarningInFunction
            << "Patch " << feeds_[feedi].patch() << " feeds objects: one that"
            << " leaves through it has been pushed out by the flow." << nl
            << "    Feed later (startTime), when the flow has settled"
            << endl;
    }
}


bool Foam::fsi::openBoundaries::removeObjects()
{
    DynamicList<label> leaving;
    DynamicList<scalar> mine;
    for (label objecti = 0; objecti < objects_.size(); ++objecti)
    {
        const label sidei = sideLeft(objecti);
        if (sidei >= 0)
        {
            const point p(centreOf(objects_.surfaces().bounds(objecti)));
            leaving.append(objecti);
            mine.append(objects_.objectGroup(objecti));
            mine.append(objects_.objectId(objecti));
            mine.append(sidei);
            mine.append(feedAt(sidei, p));
            mine.append(p.x());
            mine.append(p.y());
            mine.append(p.z());
        }
    }
    if (objects_.ranks().largest(leaving.size()) == 0)
    {
        return false;
    }

    // All ranks count and tell in the same order
    const scalarList numbers(objects_.ranks().gathered(scalarList(mine)));
    std::map<labelPair, label> order;
    for (label i = 0; i < numbers.size(); i += 7)
    {
        order[labelPair(label(numbers[i]), label(numbers[i + 1]))] = i;
    }
    for (const auto& left : order)
    {
        const scalar* of = &numbers[left.second];
        const label sidei = label(of[2]);
        ++removed_[sidei];
        Info<< "Object " << left.first.second() << " of shape "
            << objects_.shape(left.first.first()).name() << " left through "
            << nearestPatch
               (
                   grid_.mesh().boundaryMesh(),
                   sides_.patches(sidei),
                   point(of[4], of[5], of[6])
               )
            << ", " << removed_[sidei] << " so far" << endl;
        warn(label(of[3]));
    }
    objects_.remove(leaving);
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::openBoundaries::openBoundaries
(
    const cartesianMesh& grid,
    const domainSides& sides,
    population& objects,
    const dictionary& fsiProperties
)
:
    grid_(grid),
    sides_(sides),
    objects_(objects),
    removed_(6, Zero),
    nWarnings_(0)
{
    const dictionary& dict = fsiProperties.subOrEmptyDict("boundaries");
    checkKeys(dict, {"feed"});
    checkSubDicts(dict, {"feed"});
    const dictionary& feeds = dict.subOrEmptyDict("feed");
    for (const entry& e : feeds)
    {
        const bool open = sides.findPatch(e.keyword()) >= 0;
        if (!open && userVariables::has(feeds, e.keyword()))
        {
            continue;
        }
        if (!e.isDict() || !open)
        {
            FatalIOErrorInFunction(feeds)
                << "Entry '" << e.keyword() << "' in dictionary "
                << feeds.name() << " must be the name of an open patch on"
                << " one side, with a dictionary; open patches are "
                << flatOutput(sides.openPatches()) << exit(FatalIOError);
        }
        feeds_.append
        (
            new objectFeed(grid, sides, objects, e.keyword(), e.dict())
        );
    }
    read();
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::label Foam::fsi::openBoundaries::nRemoved(const Time& time)
{
    return sum(state(time).lookupOrDefault("removed", labelList()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::openBoundaries::update(const scalar time)
{
    bool changed = removeObjects();
    for (objectFeed& feed : feeds_)
    {
        changed = feed.update(time) || changed;
    }
    return changed;
}


Foam::label Foam::fsi::openBoundaries::nFed() const
{
    label n = 0;
    for (const objectFeed& feed : feeds_)
    {
        n += feed.nFed();
    }
    return n;
}


void Foam::fsi::openBoundaries::write() const
{
    const Time& time = grid_.mesh().time();
    writeFile
    (
        time, nameOf(time), "uniform", "fsiBoundaries", IOstream::ASCII,
        [&](Ostream& os)
        {
            putList(os, "removed", removed_);
            beginDict(os, "feed");
            for (const objectFeed& feed : feeds_)
            {
                beginDict(os, feed.patch());
                feed.write(os);
                endDict(os);
            }
            endDict(os);
        }
    );
}


// ************************************************************************* //
