// SPDX-License-Identifier: GPL-3.0-or-later

#include "groupEntries.H"
#include "labelField.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamTypes.H"
#include "HashSet.H"
#include "ListOps.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fsi::readGroupIds
(
    const dictionary& dict,
    const word& shapeName
)
{
    checkKeys
    (
        dict,
        {
            "FoamFile", "motion", "shape", "objectIds", "positions",
            "velocities", "lastMean", "lastVelocities", "meanLoad",
            "lastLoad", "owedImpulse", "contactRange", "contactForce",
            "periods", "springStates", "anchors",
            "elasticForces", "naturalMetrics"
        }
    );
    const word name(getEntry<word>(dict, "shape"));
    if (name != shapeName)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape' in dictionary " << dict.name() << " is " << name
            << " but must be " << shapeName << exit(FatalIOError);
    }
    const labelList ids(readEntry<labelList>(dict, "objectIds"));
    if (ids.size() && (min(ids) < 0 || labelHashSet(ids).size() < ids.size()))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'objectIds' in dictionary " << dict.name()
            << " has a negative id or one twice: " << flatOutput(ids)
            << exit(FatalIOError);
    }
    return ids;
}


// ************************************************************************* //
