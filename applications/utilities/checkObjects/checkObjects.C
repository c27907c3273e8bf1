// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    checkObjects

Description
    Checks the objects of a case at its written times: surfaces that overlap or
    cross themselves, areas, objects lost, double or outside the domain; see
    Foam::fsi::populationCheck. Overlap is decided with exact predicates.

    Prints a line per time, more where something is wrong, and at the end
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
        Largest |A/A0 - 1| of an object, A0 the area of its shape; 0.001 if
        it is not given

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "populationCheck.H"
#include "Time.H"
#include "timeSelector.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Check the objects of a case at its written times");
    argList::noParallel();
    timeSelector::addOptions(false);
    #include "addRegionOption.H"
    argList::addOption
    (
        "areaTolerance", "change", "Largest change of an area (0.001)"
    );

    #include "setRootCase.H"
    #include "createTime.H"
    const instantList times = timeSelector::select0(runTime, args);
    #include "createNamedMesh.H"

    const fsi::populationCheck checks
    (
        mesh,
        args.opt<scalar>("areaTolerance", 1e-3)
    );

    label nFaults = 0;
    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        const fsi::population objects(runTime);
        const auto found = checks.check(objects);
        nFaults += found.nFaults();
        Info<< "Time = " << runTime.timeName() << ": ";
        found.write(Info);
    }

    if (times.empty())
    {
        FatalErrorInFunction
            << "There is no time to check" << exit(FatalError);
    }
    Info<< nl << (nFaults ? "Objects are not sound: " : "Objects are sound: ")
        << nFaults << " faults in " << times.size() << " times" << nl << endl;
    // The end of argList would make it 0
    UPstream::exit(nFaults ? 1 : 0);
    return 0;
}


// ************************************************************************* //
