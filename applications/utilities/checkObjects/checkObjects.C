// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    checkObjects

Description
    Checks the objects of a case at its written times: surfaces that overlap or
    cross themselves, areas or volumes, objects lost, double or outside the
    domain; see Foam::fsi::populationCheck. Overlap is decided with exact
    predicates.
    Objects that are fed or leave may lie beyond an open side, and those that
    left are not lost. From global.csv it checks the numbers of objects and
    their areas in every step; on demand the speed of objects and fluid, and
    the time step; see Foam::fsi::historyCheck.

    Prints a line per time (times without objects, of function objects, are
    none), more where something is wrong, and at the end
    "Objects are sound" or "Objects are not sound" with the number of faults.
    The exit status is 0 only if there is none. A decomposed case is
    reconstructed first (reconstructPar).

Usage
    \b checkObjects [OPTION]

      - \par -time \<ranges\>
        Only these times, as 0:5 or 1,2

      - \par -latestTime
        Only the last time

      - \par -areaTolerance \<change\>
        Largest |A/A0 - 1| of an object, A0 the area of its shape, in 3D the
        volume; 0.001 if it is not given

      - \par -maxSpeed \<speed\>
        Largest speed of a node of an object in any step, and of the fluid at
        the written times [m/s]

      - \par -minStep \<fraction\>
        Smallest time step over the median of all

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "historyCheck.H"
#include "letOverflow.H"
#include "meshFiles.H"
#include "openBoundaries.H"
#include "openfoamCase.H"
#include "openfoamVersion.H"
#include "populationCheck.H"
#include "stepHistory.H"
#include "timeSelector.H"
#include "volFields.H"
#include "writtenFiles.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Check the fluid's speed at the current time, if there is a velocity field;
//  the number of faults
static label checkFluid(const fvMesh& mesh, const scalar maxSpeed)
{
    IOobject io("U", fsi::nameOf(mesh.time()), mesh, IOobject::MUST_READ);
    if (!fsi::hasFile<volVectorField>(io))
    {
        return 0;
    }
    const scalar speed = max(mag(volVectorField(io, mesh).primitiveField()));
    const bool tooFast = !(speed <= maxSpeed);
    Info<< "    " << (tooFast ? "Fluid is too fast: " : "fluid's speed ")
        << speed << nl;
    return tooFast;
}


//- Warn of processor folders that hold later times than the case
static void warnOfRanks(const Time& runTime)
{
    const fileName rank(runTime.globalPath()/"processor0");
    if (!isDir(rank))
    {
        return;
    }
    const scalar latest = runTime.times().last().value();
    const scalar latestOfRank = fsi::timesIn(rank).last().value();
    if (latestOfRank > latest)
    {
        WarningInFunction
            << "The latest time here is " << latest << ", in processor0 "
            << latestOfRank << ": run reconstructPar first" << nl << endl;
    }
}


//- The options of this application
static void addOptions()
{
    argList::addNote("Check the objects of a case at its written times");
    argList::noParallel();
    timeSelector::addOptions(false);
    argList::addOption
    (
        "areaTolerance", "change",
        "Largest change of an area, in 3D of a volume (0.001)"
    );
    argList::addOption
    (
        "maxSpeed", "speed", "Largest speed of objects and fluid (any)"
    );
    argList::addOption
    (
        "minStep", "fraction", "Smallest time step over the median (any)"
    );
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    addOptions();
    #include "addRegionOption.H"
    #include "setRootCase.H"
    fsi::letOverflow();
    #include "createTime.H"
    const instantList times = timeSelector::select0(runTime, args);
    #include "createCaseMesh.H"
    warnOfRanks(runTime);

    fsi::historyCheck limits;
    limits.nDims = mesh.nSolutionD();
    limits.areaTolerance = fsi::optionOr<scalar>(args, "areaTolerance", 1e-3);
    limits.maxSpeed = fsi::optionOr<scalar>(args, "maxSpeed", 0);
    limits.minStep = fsi::optionOr<scalar>(args, "minStep", 0);
    const fsi::populationCheck checks(mesh, limits.areaTolerance);

    label nFaults = limits.check
    (
        fsi::stepHistory
        (
            runTime.globalPath()/"postProcessing"/fsi::bodyGroups::folder
        ),
        Info
    );
    label nTimes = 0;
    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        if (!fsi::writtenFiles::holdsState(runTime.timePath()))
        {
            Info<< "Time = " << fsi::nameOf(runTime) << ": no objects" << nl;
            continue;
        }
        ++nTimes;
        const fsi::population objects(runTime);
        const auto found =
            checks.check(objects, fsi::openBoundaries::nRemoved(runTime));
        nFaults += found.nFaults();
        Info<< "Time = " << fsi::nameOf(runTime) << ": ";
        found.write(Info);
        if (limits.maxSpeed > 0)
        {
            nFaults += checkFluid(mesh, limits.maxSpeed);
        }
    }

    if (nTimes == 0)
    {
        FatalErrorInFunction
            << "There is no time with objects to check" << exit(FatalError);
    }
    Info<< nl << (nFaults ? "Objects are not sound: " : "Objects are sound: ")
        << nFaults << " faults in " << nTimes << " times" << nl << endl;
    const int status = nFaults ? 1 : 0;
    fsi::endProgram(status);
    return status;
}


// ************************************************************************* //
