// SPDX-License-Identifier: GPL-3.0-or-later

#include "openBoundaries.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "objectWriter.H"
#include "openfoamMesh.H"
#include "openfoamVersion.H"
#include "stateFile.H"
#include "userVariables.H"

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
    if (sides.openPatches().size())
    {
        table_ = objectWriter::newTable
        (
            grid.mesh().time(),
            "removed",
            {
                "time", "object", "shape", "patch",
                "centroidX", "centroidY", "centroidZ",
                "velocityX", "velocityY", "velocityZ"
            }
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
    bool changed = removeObjects(time);
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
