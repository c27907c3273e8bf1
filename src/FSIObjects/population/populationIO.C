// SPDX-License-Identifier: GPL-3.0-or-later

#include "population.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "IOobjectList.H"
#include "stateChecks.H"
#include "writtenDictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A file that must be there
IOobject input
(
    const Time& time,
    const fileName& instance,
    const fileName& local,
    const word& name
)
{
    return IOobject
    (
        name, instance, local, time,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
}

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::population::readCounters()
{
    IOobject io(input(time_, time_.timeName(), "uniform", "fsiPopulation"));
    if (!stateFile::exists(io))
    {
        FatalErrorInFunction
            << "There is no population of objects in "
            << io.objectPath() << nl
            << "Run seedObjects, and decomposePar after it"
            << exit(FatalError);
    }
    const dictionary dict(stateFile::read(io));
    stateChecks::compareRanks(dict);
    checkKeys
    (
        dict,
        {"FoamFile", "nDims", "planeZ", "nextObjectId", "periods"}
    );

    const label n = dict.get<label>("nDims");
    if (n != 2 && n != 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nDims' in " << dict.name() << " is " << n
            << " but must be 2 or 3" << exit(FatalIOError);
    }
    nDims_ = n;
    planeZ_ = dict.get<scalar>("planeZ");
    nextObjectId_ = dict.get<label>("nextObjectId");
    if (dict.found("periods"))
    {
        periods_ = readEntry<Map<labelVector>>(dict, "periods");
    }
}


void Foam::fsi::population::readGroups()
{
    const IOobjectList files(time_, time_.caseConstant(), folder);
    for (const word& name : files.sortedNames())
    {
        const dictionary shape
        (
            stateFile::read
            (
                input(time_, time_.caseConstant(), folder, name)
            )
        );
        shapes_.append(new shapeTemplate(shape));
        stateChecks::checkShape(shape, shapes_.last(), name, nDims_);

        // The state refers to what seedObjects wrote
        const dictionary state
        (
            stateFile::read
            (
                input(time_, time_.timeName(), "uniform"/folder, name)
            )
        );
        stateChecks::compareRanks(state);
        checkSubDicts(state, {"motion"});
        motions_.append(state.subDict("motion"));
        groups_.append(bodyGroup::New(shapes_.last(), motions_.last()));
        groups_.last().read(state);
        stateChecks::checkIds(state, groups_, nextObjectId_);
    }

    forAllConstIters(periods_, iter)
    {
        if (findObject(iter.key()) < 0)
        {
            FatalErrorInFunction
                << "Entry 'periods' in "
                << time_.timePath()/"uniform/fsiPopulation" << " has the id "
                << iter.key() << ", but there is no such object"
                << exit(FatalError);
        }
    }

    const IOobjectList states(time_, time_.timeName(), "uniform"/folder);
    for (const word& name : states.sortedNames())
    {
        if (!files.found(name))
        {
            FatalErrorInFunction
                << "There is no shape "
                << time_.path()/time_.caseConstant()/folder/name
                << " of the objects in " << states[name]->objectPath() << nl
                << "Restore it, or run seedObjects"
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::population::write() const
{
    const fileName uniform(fileName(time_.timeName())/"uniform");

    writeFile
    (
        time_, time_.timeName(), "uniform", "fsiPopulation", IOstream::ASCII,
        [&](Ostream& os)
        {
            os.writeEntry("nDims", label(nDims_));
            os.writeEntry("planeZ", planeZ_);
            os.writeEntry("nextObjectId", nextObjectId_);
            if (periods_.size())
            {
                os.writeEntry("periods", periods_);
            }
        }
    );

    forAll(groups_, groupi)
    {
        writeFile
        (
            time_, time_.timeName(), "uniform"/folder,
            shapes_[groupi].name(), time_.writeFormat(),
            [&](Ostream& os)
            {
                motions_[groupi].writeEntry("motion", os);
                groups_[groupi].write(os);
            }
        );
    }
}


void Foam::fsi::population::writeShapes() const
{
    if (!Pstream::master())
    {
        return;
    }
    forAll(shapes_, groupi)
    {
        writeFile
        (
            time_, time_.caseConstant(), folder, shapes_[groupi].name(),
            IOstream::ASCII,
            [&](Ostream& os) { shapes_[groupi].write(os); }
        );
    }
}


// ************************************************************************* //
