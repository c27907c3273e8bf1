// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroups.H"
#include "dictionaryCheck.H"
#include "IOobjectList.H"
#include "latticeRanks.H"
#include "openfoamVersion.H"
#include "stateChecks.H"
#include "stateFile.H"
#include "swapLists.H"

// * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * * //

const Foam::word Foam::fsi::bodyGroups::folder("fsiObjects");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Names of the files that the first rank finds in a folder
static wordList namesIn
(
    const Time& time,
    const fileName& instance,
    const fileName& local
)
{
    return ofFirstRank
    (
        wordList(IOobjectList(time, instance, local).sortedNames())
    );
}


//- Mean of the surface nodes of a copy [m]
static point meanOf(const bodyGroup& group, const label copyi)
{
    const label nDims = group.shape().nDims();
    point mean(Zero);
    for (direction d = 0; d < nDims; ++d)
    {
        const auto x = group.positions().col(nDims*copyi + d);
        mean[d] = x.head(group.shape().nBoundaryNodes()).mean();
    }
    return mean;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::bodyGroups::readShape(const word& name, const direction nDims)
{
    const dictionary shape
    (
        stateFile::read
        (
            stateFile::input(time_, caseConstant(time_), folder, name)
        )
    );
    shapes_.push_back(std::make_shared<shapeTemplate>(shape));
    stateChecks::checkShape(shape, *shapes_.back(), name, nDims);
}


void Foam::fsi::bodyGroups::readCopies(const label nextId, labelHashSet& taken)
{
    const bool first = rankIn() == 0;
    const shapeTemplate& shape = *shapes_.back();
    const dictionary state
    (
        stateFile::readOnFirst
        (
            stateFile::input
            (
                time_, nameOf(time_), "uniform"/folder, shape.name()
            )
        )
    );
    dictionary motion;
    if (first)
    {
        checkSubDicts(state, {"motion"});
        motion = state.subDict("motion");
        groups_.append(bodyGroup::New(shape, motion));
        groups_.last().read(state);
        stateChecks::checkIds(state, groups_.last(), nextId, taken);
        groups_.last().sort();
    }
    motions_.append(ofFirstRank(motion));
    if (!first)
    {
        groups_.append(bodyGroup::New(shape, motions_.last()));
    }
}


void Foam::fsi::bodyGroups::sendCopies
(
    bodyGroup& group,
    const cellOwners& cells
)
{
    group.setHistory(ofFirstRank(group.history()));
    const bool first = rankIn() == 0;
    copyValues one;
    if (first && group.size())
    {
        group.take(0, one);
    }
    const label width = ofFirstRank(one.values().size());
    const label nCopies = ofFirstRank(group.size());

    // Blocks of some ten million numbers
    const label block = max(label(1), 10000000/max(width, label(1)));
    DynamicList<label> left, owners, comes;
    for (label start = 0; start < nCopies; start += block)
    {
        const label end = min(start + block, nCopies);
        pointField centres;
        for (label copyi = start; first && copyi < end; ++copyi)
        {
            centres.append(meanOf(group, copyi));
        }
        const labelList ranks(cells.ranksAt(ofFirstRank(centres)));
        comes.append(0);
        for (const label ranki : ranks)
        {
            comes.last() += ranki == rankIn();
        }
        if (first)
        {
            owners.append(ranks);
        }
    }

    label next = first ? group.size() : 0;
    group.resize(first ? group.size() : sum(comes));
    labelList sizes(nRanksIn(), Zero);
    forAll(comes, blocki)
    {
        List<DynamicList<scalar>> sent(nRanksIn());
        const label start = blocki*block;
        for (label i = start; first && i < min(start + block, nCopies); ++i)
        {
            if (owners[i] > 0)
            {
                copyValues values;
                group.take(i, values);
                sent[owners[i]].append(values.values());
                left.append(i);
            }
        }
        sizes[0] = first ? 0 : width*comes[blocki];
        copyValues values(swapLists(sent, sizes)[0]);
        while (values.more())
        {
            group.exchange(next++, values);
        }
    }
    group.remove(left);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyGroups::bodyGroups(const Time& time)
:
    time_(time)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::bodyGroups::stays(const label groupi) const
{
    return motions_[groupi].lookupOrDefault<word>("type", "") == "fixed";
}


Foam::wordList Foam::fsi::bodyGroups::shapeNames() const
{
    wordList names(size());
    forAll(names, groupi)
    {
        names[groupi] = shape(groupi).name();
    }
    return names;
}


Foam::label Foam::fsi::bodyGroups::append
(
    autoPtr<shapeTemplate> shape,
    const dictionary& motion
)
{
    if (isIn(shapeNames(), shape->name()))
    {
        FatalErrorInFunction
            << "There is a shape named " << shape->name() << " already"
            << exit(FatalError);
    }
    shapes_.emplace_back(shape.ptr());
    motions_.append(motion);
    groups_.append(bodyGroup::New(*shapes_.back(), motions_.last()));
    return groups_.size() - 1;
}


void Foam::fsi::bodyGroups::shareShapes(const bodyGroups& other)
{
    shapes_ = other.shapes_;
    motions_ = other.motions_;
    groups_.clear();
    forAll(motions_, groupi)
    {
        groups_.append(bodyGroup::New(shape(groupi), motions_[groupi]));
    }
}


void Foam::fsi::bodyGroups::read
(
    const direction nDims,
    const label nextId,
    const cellOwners& cells
)
{
    const wordList names(namesIn(time_, caseConstant(time_), folder));
    labelHashSet taken;
    for (const word& name : names)
    {
        readShape(name, nDims);
        readCopies(nextId, taken);
        if (nRanksIn() > 1)
        {
            sendCopies(groups_.last(), cells);
        }
    }

    const fileName local("uniform"/folder);
    for (const word& name : namesIn(time_, nameOf(time_), local))
    {
        if (!isIn(names, name))
        {
            FatalErrorInFunction
                << "There is no shape "
                << time_.path()/caseConstant(time_)/folder/name
                << " of the objects in " << time_.timePath()/local/name << nl
                << "Restore it, or run seedObjects"
                << exit(FatalError);
        }
    }
}


void Foam::fsi::bodyGroups::write() const
{
    forAll(groups_, groupi)
    {
        writeFile
        (
            time_, nameOf(time_), "uniform"/folder,
            shape(groupi).name(), time_.writeFormat(),
            [&](Ostream& os)
            {
                putDict(os, "motion", motions_[groupi]);
                groups_[groupi].write(os);
            }
        );
    }
}


void Foam::fsi::bodyGroups::writeShapes() const
{
    forAll(groups_, groupi)
    {
        writeFile
        (
            time_, caseConstant(time_), folder, shape(groupi).name(),
            IOstream::ASCII,
            [&](Ostream& os) { shape(groupi).write(os); }
        );
    }
}


// ************************************************************************* //
