// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    seedObjects

Description
    Makes the objects of a case from system/seedObjectsDict.

    Writes constant/fsiObjects (shapes), constant/fsiSeeding (the mesh they are
    made for), uniform/fsiObjects of the start time
    (state of the copies) and, to look at the set-up before it is run,
    postProcessing/seedObjects/surfaces.vtp and springs.vtp. Objects that were
    seeded there before are replaced; those of a time that a run wrote are not.

    The mesh must be uniform and Cartesian. Run it before decomposePar, which
    copies the state to the processors.

Usage
    \b seedObjects [OPTION]

      - \par -dict \<file\>
        Alternative dictionary

      - \par -weights
        Write the field cellWork, by which decomposePar can cut ranks of equal
        work: entry `weightField cellWork;` of decomposeParDict

    For the dictionary see Foam::fsi::seeding.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "cartesianMesh.H"
#include "contact.H"
#include "letOverflow.H"
#include "meshFiles.H"
#include "objectPolyData.H"
#include "openfoamCase.H"
#include "seeding.H"
#include "timeFolders.H"
#include "volFields.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Fatal if the start time is one that a run with objects wrote
static void refuseRun(const Time& runTime)
{
    const fileName written(runTime.timePath()/"uniform"/"fsiRestart");
    const label n = isFile(written) ? fsi::population(runTime).size() : 0;
    if (n > 0)
    {
        FatalErrorInFunction
            << "Time " << fsi::nameOf(runTime) << " has the " << n
            << " objects of a run, and seeding would drop them." << nl
            << "To seed for a new run, let startFrom be startTime or firstTime"
            << " in controlDict, or remove the times of the old one." << nl
            << "To go on from the flow of this time with other objects, remove "
            << written << exit(FatalError);
    }
}


//- Replace the objects of a case
static void write(const Time& runTime, const fsi::population& objects)
{
    fileNameList old(2);
    old[0] = runTime.path()/runTime.constant()/fsi::bodyGroups::folder;
    old[1] = runTime.timePath()/"uniform"/fsi::bodyGroups::folder;
    for (const fileName& folder : old)
    {
        if (isDir(folder))
        {
            rmDir(folder);
        }
    }
    objects.writeShapes();
    objects.write();

    const fileName folder("postProcessing/seedObjects");
    const fileName pictures(runTime.globalPath()/folder);
    fsi::surfacePolyData(objects).write
    (
        pictures/"surfaces.vtp", runTime.value()
    );
    fsi::springPolyData(objects).write
    (
        pictures/"springs.vtp", runTime.value()
    );
    Info<< "Look at the set-up in " << folder << nl;
}


//- Gap below which the solver lets objects push each other [m]
static scalar contactRange(const Time& runTime, const scalar spacing)
{
    const IOdictionary properties
    (
        IOobject
        (
            "fsiProperties",
            runTime.constant(),
            runTime,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    return fsi::contact::readRange
    (
        properties.subOrEmptyDict("contact"), spacing
    );
}


//- The domain of the mesh, and the dictionary. The mesh takes more memory than
//  objects: it goes before they come
static fsi::seedDomain readDomain
(
    const argList& args,
    const Time& runTime,
    dictionary& dict
)
{
    #include "createCaseMesh.H"

    dict = IOdictionary(fsi::systemFile(args, mesh, "seedObjectsDict"));
    const fsi::cartesianMesh lattice(mesh);
    return fsi::seedDomain
    {
        lattice.bounds(),
        lattice.spacing(),
        lattice.thickness(),
        lattice.nDims(),
        contactRange(runTime, lattice.spacing()),
        lattice.period()
    };
}


//- Write the work of each cell, in that of a cell without objects. A step takes
//  for a node of an object some four times as long as for such a cell
static void writeWork
(
    const argList& args,
    const Time& runTime,
    const fsi::population& objects
)
{
    #include "createCaseMesh.H"

    const fsi::cartesianMesh lattice(mesh);
    volScalarField work
    (
        IOobject("cellWork", fsi::nameOf(runTime), mesh),
        mesh,
        dimensionedScalar("work", dimless, 1)
    );
    const label nDims = objects.nDims();
    forAll(objects.groups(), groupi)
    {
        const auto& positions = objects.groups()[groupi].positions();
        for (label column = 0; column < positions.cols(); column += nDims)
        {
            for (label nodei = 0; nodei < positions.rows(); ++nodei)
            {
                point p(0, 0, objects.planeZ());
                for (label d = 0; d < nDims; ++d)
                {
                    p[d] = positions(nodei, column + d);
                }
                const label celli = lattice.findCell(p);
                if (celli >= 0)
                {
                    work[celli] += 4;
                }
            }
        }
    }
    work.write();
    Info<< "Wrote " << work.name() << nl;
}


int main(int argc, char *argv[])
{
    argList::addNote("Make the objects of a case from a dictionary");
    argList::noParallel();
    #include "addRegionOption.H"
    argList::addOption("dict", "file", "Alternative seedObjectsDict");
    argList::addBoolOption("weights", "Write the cells' work for decomposePar");

    #include "setRootCase.H"
    fsi::letOverflow();
    #include "createTime.H"
    fsi::nameByFolder(runTime);
    refuseRun(runTime);

    dictionary dict;
    const fsi::seedDomain domain(readDomain(args, runTime, dict));
    const fsi::seeding seeding(runTime, domain, dict);

    Info<< "Seeded" << nl;
    seeding.report(Info);
    runTime.cpuTimeIncrement();
    write(runTime, seeding.objects());
    seeding.writeRecord(runTime);
    if (fsi::hasOption(args, "weights"))
    {
        writeWork(args, runTime, seeding.objects());
    }
    Info<< "Wrote all in " << runTime.cpuTimeIncrement() << " s, "
        << runTime.elapsedCpuTime() << " s since the start" << nl
        << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
