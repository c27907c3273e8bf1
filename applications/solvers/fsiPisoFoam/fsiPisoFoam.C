// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    fsiPisoFoam

Group
    grpIncompressibleSolvers

Description
    Transient solver for an incompressible viscous fluid with many deformable
    objects in it, on a uniform Cartesian mesh.

    Objects are seeded by seedObjects. doc/dataFlow.md explains the step,
    fsiObjects.H the entries of constant/fsiProperties.

    Entries of controlDict beside OpenFOAM's own:
    \table
        Property       | Description                           | Default
        adjustTimeStep | follow the Courant number             | no
        maxCo          | largest Courant number of fluid and objects | 0.5
        maxDeltaT      | largest time step [s]                 | deltaT
        maxTimeError   | largest error of a step (timeError); 0: none | 0
        minDeltaT      | smallest time step, else the run ends [s]; 1e-4 of
                         the largest since the tenth step     | 1e-4
        maxDiffusion   | largest dt nu d/h^2; 0: none          | 0
    \endtable

    Of system/fvSchemes two schemes are used: div(phi,U), Gauss with any
    interpolation, and ddt(U), Euler or backward (timeRule.H). Laplacians and
    gradients are differences between neighbours, as with any scheme on such a
    mesh, with the open parts of faces at objects.

    Of system/fvSolution the dictionaries of p and U are read. With the default
    coupling solidImplicit only their tolerance, relTol and maxIter count, and
    the multigrid's entries (immersedStep.H): whatever \c solver names, p is
    solved by the multigrid and U by relaxation. There is one pressure equation
    per pass of a step (passes of the coupling); \c nCorrectors and \c pFinal
    are not used: let relTol of p be 0.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "fvOptions.H"
#include "caseLock.H"
#include "fieldChecks.H"
#include "fileHeaders.H"
#include "fsiStep.H"
#include "laminarFluid.H"
#include "letOverflow.H"
#include "meshFiles.H"
#include "openfoamCase.H"
#include "openfoamVersion.H"
#include "optionSources.H"
#include "osha1stream.H"
#include "restartFiles.H"
#include "solverTime.H"
#include "timeStep.H"
#include "writtenFiles.H"
#include <malloc.h>

// For -postProcess
#define CREATE_FIELDS createFluid.H
#define CREATE_MESH createCaseMesh.H
#define NO_CONTROL

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Take a step that is not written
static int tryStep(Foam::fsi::fsiStep& step, const Foam::fsi::flowSources& s)
{
    step.advance(s);
    Info<< "One step was taken. No time is written: -dry-run. The tables of"
        << " this step are in postProcessing-dry-run" << nl
        << "End\n" << endl;
    return 0;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Deformable objects in an incompressible fluid on a Cartesian mesh"
    );

    #include "keepMemory.H"
    #include "postProcess.H"
    argList::addBoolOption
    (
        "dry-run", "Read all and take one time step, which is not written"
    );
    #include "setRootCaseLists.H"
    fsi::letOverflow();
    const bool dryRun = args.found("dry-run");
    functionObject::outputPrefix += dryRun ? "-dry-run" : "";
    const fsi::caseLock lock(args.globalPath());
    const word start(dryRun ? word() : fsi::writtenFiles::setAside(args));
    fsi::fileHeaders::check(args.globalPath()/"system");
    fsi::solverTime runTime(args, start);
    fsi::restartFiles::takeTime(runTime);
    #include "createCaseMesh.H"
    #include "createFields.H"
    #include "createFvOptions.H"

    const fsi::optionSources sources(fvOptions);
    fsi::timeStep timeStep(runTime);

    Info<< "Starting time loop\n" << endl;

    while (runTime.run())
    {
        fsi::writtenFiles::check(runTime);
        const scalar deltaT = timeStep.next(phi, *step);
        if (timeStep.adjusts())
        {
            runTime.setDeltaT(deltaT);
        }
        ++runTime;
        objects.log().name();

        if (dryRun)
        {
            return tryStep(*step, sources);
        }
        step->advance(sources);

        fsi::writtenFiles::write
        (
            runTime, [&]() { timeStep.write(); step->write(); }
        );
    }

    fsi::writtenFiles::check(runTime);
    step->checkCrossing();
    step->summary(Info);
    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
