// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroups.H"
#include "dictionaryCheck.H"
#include "IOobjectList.H"
#include "latticeRanks.H"
#include "openfoamVersion.H"
#include "stateChecks.H"
#include "stateFile.H"

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

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::bodyGroups::readGroup
(
    const word& name,
    const direction nDims,
    const label nextId,
    labelHashSet& taken
)
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

    // The state refers to what seedObjects wrote
    const dictionary state
    (
        stateFile::read
        (
            stateFile::input
            (
                time_, nameOf(time_), "uniform"/folder, name
            )
        )
    );
    checkSubDicts(state, {"motion"});
    motions_.append(state.subDict("motion"));
    groups_.append(bodyGroup::New(*shapes_.back(), motions_.last()));
    groups_.last().read(state);
    stateChecks::checkIds(state, groups_.last(), nextId, taken);
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


Foam::label Foam::fsi::bodyGroups::find(const word& shapeName) const
{
    for (label groupi = 0; groupi < size(); ++groupi)
    {
        if (shape(groupi).name() == shapeName)
        {
            return groupi;
        }
    }
    return -1;
}


Foam::label Foam::fsi::bodyGroups::append
(
    autoPtr<shapeTemplate> shape,
    const dictionary& motion
)
{
    if (find(shape->name()) >= 0)
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


void Foam::fsi::bodyGroups::read(const direction nDims, const label nextId)
{
    const wordList names(namesIn(time_, caseConstant(time_), folder));
    labelHashSet taken;
    for (const word& name : names)
    {
        readGroup(name, nDims, nextId, taken);
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
