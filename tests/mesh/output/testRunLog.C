// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "../boxMesh.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "runLog.H"
#include "needsThrownErrors.H"

using namespace Foam;
using Foam::fsi::boxMesh;
using Foam::fsi::runLog;
using Foam::fsi::stepRecord;
using Foam::fsi::stepTimer;

namespace
{

//- A step with numbers of the length that is given
stepRecord record(const scalar size)
{
    stepRecord r;
    r.time = 0.123456789;
    r.deltaT = 1.23456e-6;
    r.objects = 20;
    r.contacts = label(7*size);
    r.smallestGap = 1.23456e-7;
    r.maxSpeed = 1.23456e-4;
    return r;
}

} // End namespace


TEST(RunLog, lineTellsTheStep)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    runLog log(box.mesh().time(), dictionary());
    stepTimer timer;
    log.start(0.1, 0.352);
    log.count("U", 12);
    log.count("p", 7);
    log.count("p", 8);
    const std::string line = log.line(record(3), timer);
    for (const std::string part :
        {"Time = ", " left)", "dt 1.23e-06", "Co 0.352", "U 12", "p 15",
         "contacts 21", "gap 1.23e-07", "speed 0.000123"})
    {
        EXPECT_NE(line.find(part), std::string::npos) << part << ": " << line;
    }
    EXPECT_LE(line.size(), size_t(runLog::width));
}


TEST(RunLog, lineOfLongNumbersFits)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    runLog log(box.mesh().time(), dictionary());
    stepTimer timer;
    timer.endStep(0, 1e-9, 1);
    log.start(123456, 0);
    for (const word name : {"U", "p", "passes", "UxUyUz"})
    {
        log.count(name, 123456789);
    }
    const std::string line = log.line(record(1e8), timer);
    EXPECT_LE(line.size(), size_t(runLog::width)) << line;
    EXPECT_NE(line.find("Co 1.23e+05"), std::string::npos) << line;
}


TEST(RunLog, summaryCountsWarnings)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    runLog log(box.mesh().time(), dictionary());
    EXPECT_EQ(log.warnings(), "none");

    stepTimer timer;
    for (label stepi = 0; stepi < 3; ++stepi)
    {
        const bool converged = stepi == 1;
        log.start(0.1*(stepi + 1), 0);
        log.solved
        (
            solverPerformance("GS", "U", 1, 0.1, 10*stepi, converged, false)
        );
        log.finish(record(stepi), timer);
    }
    EXPECT_EQ(log.warnings(), "2 x U not converged");

    OStringStream os;
    log.report(os);
    const std::string text = os.str();
    for (const std::string part :
        {"Summary of 3 steps", "up to 0.3", "U 10", "2 x U not converged"})
    {
        EXPECT_NE(text.find(part), std::string::npos) << part << ": " << text;
    }
}


TEST(RunLog, unknownChoiceIsRefused)
{
    NEEDS_THROWN_ERRORS
    boxMesh box(labelVector(8, 8, 1), 2);
    IStringStream is("log all;");
    const dictionary dict(is);
    EXPECT_THROW(runLog(box.mesh().time(), dict), Foam::IOerror);
}
