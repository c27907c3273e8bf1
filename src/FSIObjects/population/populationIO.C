// SPDX-License-Identifier: GPL-3.0-or-later

#include "population.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "stateChecks.H"
#include "stateFile.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::population::readCounters()
{
    const IOobject io
    (
        stateFile::input(time_, nameOf(time_), "uniform", "fsiPopulation")
    );
    if (!stateFile::exists(io))
    {
        FatalErrorInFunction
            << "There is no population of objects in "
            << pathOf(io) << nl
            << "Run seedObjects, and decomposePar after it"
            << exit(FatalError);
    }
    const dictionary dict(stateFile::read(io));
    checkKeys
    (
        dict,
        {"FoamFile", "nDims", "planeZ", "nextObjectId"}
    );

    const label n = readEntry<label>(dict, "nDims");
    if (n != 2 && n != 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nDims' in " << dict.name() << " is " << n
            << " but must be 2 or 3" << exit(FatalIOError);
    }
    setDirections(n);
    planeZ_ = readEntry<scalar>(dict, "planeZ");
    nextObjectId_ = readEntry<label>(dict, "nextObjectId");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::population::write() const
{
    writeFile
    (
        time_, nameOf(time_), "uniform", "fsiPopulation", IOstream::ASCII,
        [&](Ostream& os)
        {
            putEntry(os, "nDims", label(nDims_));
            putEntry(os, "planeZ", planeZ_);
            putEntry(os, "nextObjectId", nextObjectId_);
        }
    );
    groups_.write();
}


// ************************************************************************* //
