// SPDX-License-Identifier: GPL-3.0-or-later

/*---------------------------------------------------------------------------*\
Program
    fsiMeshTests

Description
    Runs the tests that need an fvMesh: tests/mesh/<area>/test*.C, GoogleTest,
    with the meshes of boxMesh.H, serial or on several ranks.
    OpenFOAM's fatal errors are exceptions here (Foam::error,
    Foam::IOerror), so that a test can expect them.

    On several ranks every rank runs every test. A test that fails on one rank
    has failed: ranks agree after each test, rank 0 prints the outcome and the
    others print their failures to stderr.

Usage
    fsiMeshTests [--gtest_filter=Suite.Test] ...
    mpirun -np 2 fsiMeshTests -parallel [--gtest_filter=Suite.Test] ...
\*---------------------------------------------------------------------------*/

#include <gtest/gtest.h>
#include <cstring>
#include <iostream>

#include "collectiveCalls.H"
#include "openfoamCase.H"
#include "PstreamReduceOps.H"
#include "errorOf.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace
{

//- Makes a failure on one rank a failure on all
class agreeOnFailure
:
    public ::testing::EmptyTestEventListener
{
    void OnTestEnd(const ::testing::TestInfo& info) override
    {
        const bool failed = info.result()->Failed();
        if (Foam::returnReduce(failed, Foam::orOp<bool>()) && !failed)
        {
            ADD_FAILURE() << "failed on another rank";
        }
    }
};


//- Prints the failures of the ranks that have no other output
class printFailures
:
    public ::testing::EmptyTestEventListener
{
    void OnTestPartResult(const ::testing::TestPartResult& result) override
    {
        if (result.failed())
        {
            std::cerr
                << "[rank " << Foam::Pstream::myProcNo() << "] "
                << (result.file_name() ? result.file_name() : "") << ':'
                << result.line_number() << '\n' << result.message() << '\n';
        }
    }
};


//- Takes the option -parallel from the command line, if it is there
bool takeParallel(int& argc, char** argv)
{
    int kept = 0;
    for (int argi = 0; argi < argc; ++argi)
    {
        if (std::strcmp(argv[argi], "-parallel") != 0)
        {
            argv[kept++] = argv[argi];
        }
    }
    const bool found = (kept < argc);
    argc = kept;
    argv[argc] = nullptr;
    return found;
}

} // End namespace


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    Foam::ParRunControl parRun;
    if (takeParallel(argc, argv))
    {
        char** arguments = argv;
        Foam::fsi::startRanks(parRun, argc, arguments);
    }
    ::testing::InitGoogleTest(&argc, argv);

    const Foam::fsi::thrownErrors thrown;

    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    if (!Foam::Pstream::master())
    {
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new printFailures);
    }
    if (Foam::Pstream::parRun())
    {
        Foam::fsi::collectiveCalls::debug = 1;
        listeners.Append(new agreeOnFailure);
    }

    return RUN_ALL_TESTS();
}


// ************************************************************************* //
