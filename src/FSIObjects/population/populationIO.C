// SPDX-License-Identifier: GPL-3.0-or-later

#include "population.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "stateChecks.H"
#include "writtenDictionary.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::population::readCounters()
{
    const IOobject io
    (
        stateFile::input(time_, time_.timeName(), "uniform", "fsiPopulation")
    );
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


void Foam::fsi::population::checkPeriods() const
{
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
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::population::write() const
{
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
    groups_.write();
}


// ************************************************************************* //
