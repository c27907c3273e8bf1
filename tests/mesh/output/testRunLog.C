// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "boxMesh.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "runLog.H"
#include "needsThrownErrors.H"

#include <sstream>

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
}


TEST(RunLog, linesHaveTheSameEntriesInOneOrder)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    runLog log(box.mesh().time(), dictionary());
    stepTimer timer;
    timer.endStep(0, 1e-9, 1);

    // Numbers are left out, and no entry is lost behind long ones
    const auto entries = [&](const stepRecord& r)
    {
        std::string names;
        std::istringstream words(log.line(r, timer));
        for (std::string word; words >> word;)
        {
            if (std::isalpha(word[0]) && word != "inf")
            {
                names += word + " ";
            }
        }
        return names;
    };
    const std::string expected
    (
        "Time left) dt Co U p passes contacts gap speed error "
    );
    log.start(123456, 0);
    for (const word name : {"p", "U", "passes"})
    {
        log.count(name, 123456789);
    }
    stepRecord r(record(1e8));
    EXPECT_EQ(entries(r), expected);
    log.finish(r, timer);

    log.start(0.1, 0);
    log.count("U", 1);
    r.smallestGap = GREAT;
    EXPECT_EQ(entries(r), expected);
    EXPECT_NE(log.line(r, timer).find("gap inf"), std::string::npos);
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
        {"Summary of 3 steps", "up to 0.3", "U 10", "2 x U not converged",
         "smallest gap      1.23e-07 m"})
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
