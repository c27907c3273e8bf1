// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>
#include <fstream>
#include <sstream>
#include <thread>

#include "population/someObjects.H"
#include "OSspecific.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "mathematicalConstants.H"
#include "objectWriter.H"
#include "needsThrownErrors.H"

using namespace Foam;
using Foam::fsi::boxMesh;
using Foam::fsi::csvTable;
using Foam::fsi::objectRecord;
using Foam::fsi::population;
using Foam::fsi::stepRecord;
using Foam::fsi::stepTimer;

namespace
{

//- Values of all lines of a file
std::vector<std::vector<std::string>> readTable(const fileName& file)
{
    std::vector<std::vector<std::string>> rows;
    std::ifstream is(file);
    for (std::string line; std::getline(is, line);)
    {
        rows.emplace_back();
        std::istringstream values(line);
        for (std::string value; std::getline(values, value, ',');)
        {
            rows.back().push_back(value);
        }
    }
    return rows;
}


//- A file as text
std::string readText(const fileName& file)
{
    std::ifstream is(file);
    std::ostringstream os;
    os << is.rdbuf();
    return os.str();
}


//- A file name of this rank only
fileName ownFile(const boxMesh& box, const word& name)
{
    return box.casePath()/("rank" + Foam::name(Pstream::myProcNo()))/name;
}


void sleep(const int milliseconds)
{
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

} // End namespace


TEST(CsvTable, writesHeaderAndRows)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    const fileName file = ownFile(box, "a.csv");
    {
        csvTable table(file, {"time", "shape", "x", "y", "z", "gap"});
        table.row() << 0.1 << word("disc") << vector(1, 2, 3) << GREAT;
    }
    const auto rows = readTable(file);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0][5], "gap");
    const std::vector<std::string> expected
    {
        "0.1", "disc", "1", "2", "3", "inf"
    };
    EXPECT_EQ(rows[1], expected);
}


TEST(CsvTable, refusesRowsOfOtherLength)
{
    NEEDS_THROWN_ERRORS
    boxMesh box(labelVector(8, 8, 1), 2);
    csvTable table(ownFile(box, "a.csv"), {"time", "x"});
    const std::string text =
        someObjects::errorText([&]() { table.row() << 0.1; });
    EXPECT_NE(text.find("1 values for 2 columns"), std::string::npos) << text;
}


TEST(StepTimer, countsEachSecondOnce)
{
    stepTimer timer;
    {
        const stepTimer::section fluid(timer, stepTimer::part::fluid);
        sleep(30);
        {
            const stepTimer::section solids(timer, stepTimer::part::solids);
            sleep(60);
        }
        sleep(30);
    }
    timer.endStep(0.1, 0.1, 1);

    const scalar fluid = timer.seconds()[label(stepTimer::part::fluid)];
    const scalar solids = timer.seconds()[label(stepTimer::part::solids)];
    EXPECT_GE(fluid, 0.06);
    EXPECT_GE(solids, 0.06);
    EXPECT_NEAR(fluid + solids, timer.stepSeconds(), 0.02);
    EXPECT_EQ(timer.seconds()[label(stepTimer::part::contact)], 0);

    // Nine more steps as long as this one
    EXPECT_NEAR(timer.remaining(), 9*timer.stepSeconds(), 1e-9);
    EXPECT_EQ(timer.nSteps(), 1);

    timer.endStep(0.2, 0.1, 1);
    EXPECT_EQ(timer.seconds()[label(stepTimer::part::fluid)], 0);
    EXPECT_EQ(timer.totalSeconds()[label(stepTimer::part::fluid)], fluid);
}


TEST(StepTimer, refusesToEndAStepInAPart)
{
    NEEDS_THROWN_ERRORS
    stepTimer timer;
    const stepTimer::section solids(timer, stepTimer::part::solids);
    const std::string text =
        someObjects::errorText([&]() { timer.endStep(0, 0.1, 1); });
    EXPECT_NE(text.find("solids"), std::string::npos) << text;
}


TEST(StepTimer, reportsAllParts)
{
    stepTimer timer;
    timer.endStep(0.1, 0.1, 1);
    OStringStream os;
    timer.report(os);
    for
    (
        const char* name :
        {
            "fluid", "pressure", "levelSet", "solids", "contact", "coupling",
            "other", "all"
        }
    )
    {
        EXPECT_NE(os.str().find(name), std::string::npos) << name;
    }
    EXPECT_EQ(stepTimer::clockString(3725.4), "1:02:05");
    EXPECT_EQ(stepTimer::clockString(GREAT), "unknown");
}


TEST(ObjectRecord, samplesGeometryAndMotion)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    const autoPtr<population> objects = someObjects::make(box.time());
    const List<objectRecord> records(objectRecord::sample(*objects, Zero));

    ASSERT_EQ(records.size(), 5);
    const objectRecord& disc = records[1];
    EXPECT_EQ(disc.object, 1);
    EXPECT_EQ(disc.shape, "disc");
    EXPECT_NEAR(mag(disc.centroid - point(5, 2, 0.5)), 0, 1e-12);

    // The centre of mass of the nodes is not exactly that of the outline
    const vector offCentre =
        objects->groups()[0].centroid(1) - point(5, 2, 0.5);
    const vector velocity = vector(1, 0, 0) + (vector(0, 0, 0.5) ^ offCentre);
    EXPECT_NEAR(mag(disc.velocity - velocity), 0, 1e-12);
    EXPECT_NEAR(disc.angularVelocity.z(), 0.5, 1e-12);
    EXPECT_NEAR(disc.area, constant::mathematical::pi, 0.1);
    EXPECT_NEAR(disc.perimeter, constant::mathematical::twoPi, 0.1);
    EXPECT_EQ(records[4].shape, "ellipse");

    // One ellipse lies along x, the other is turned by a quarter
    EXPECT_NEAR(records[3].inclination, 0, 1e-3);
    EXPECT_NEAR
    (
        mag(records[4].inclination), 0.5*constant::mathematical::pi, 1e-3
    );
    const scalar turn = records[4].phase - records[3].phase;
    EXPECT_NEAR(std::cos(turn), 0, 1e-12);
    EXPECT_NEAR(std::sin(turn), 1, 1e-12);
    EXPECT_NEAR(mag(records[4].velocity - vector(0, 2, 0)), 0, 1e-12);
}


TEST(ObjectWriter, writesTablesAndSeriesOnTheMasterOnly)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    const autoPtr<population> objects = someObjects::make(box.time());
    {
        fsi::objectWriter writer
        (
            box.time(), someObjects::dict("globalEvery 2;"), 2
        );
        stepRecord record;
        for (label stepi = 0; stepi < 5; ++stepi)
        {
            record.time = 0.25*stepi;
            writer.writeStep(record);
        }
        const List<objectRecord> records(objectRecord::sample(*objects, Zero));
        const vectorField tractions(objects->surfaces().points());
        writer.writeRows(0.25, records);
        writer.writeShapes(0.25, *objects, vector::zero, tractions);
        writer.writeRows(0.75, records);
        writer.writeShapes(0.75, *objects, vector::zero, tractions);
    }
    if (!Pstream::master())
    {
        return;
    }

    const fileName folder(box.casePath()/"postProcessing/fsiObjects/0");
    const auto objectRows = readTable(folder/"objects.csv");
    ASSERT_EQ(objectRows.size(), 1u + 2*5);
    for (const auto& row : objectRows)
    {
        EXPECT_EQ(row.size(), 32u);
    }
    EXPECT_EQ(objectRows[0][0], "time");
    EXPECT_EQ(objectRows[6][0], "0.75");
    EXPECT_EQ(objectRows[6][2], "disc");
    EXPECT_EQ(objectRows[0][20], "smallestGap");
    EXPECT_EQ(objectRows[1][20], "inf");

    const auto globalRows = readTable(folder/"global.csv");
    ASSERT_EQ(globalRows.size(), 1u + 3);
    EXPECT_EQ(globalRows[0].size(), 30u);
    EXPECT_EQ(globalRows[3].size(), 30u);
    EXPECT_EQ(globalRows[3][0], "1");

    const std::string series = readText(folder/"surfaces.vtp.series");
    EXPECT_NE(series.find("surfaces_000001.vtp\", \"time\" : 0.75"),
        std::string::npos) << series;
    const std::string springs = readText(folder/"springs_000001.vtp");
    EXPECT_NE(springs.find("Name='strain'"), std::string::npos);
    const std::string surfaces = readText(folder/"surfaces_000000.vtp");
    EXPECT_NE(surfaces.find("NumberOfPolys='5'"), std::string::npos);
    EXPECT_NE(surfaces.find("Name='traction'"), std::string::npos);
    EXPECT_NE(surfaces.find("Name='velocity'"), std::string::npos);
}


TEST(ObjectWriter, refusesUnknownKeys)
{
    NEEDS_THROWN_ERRORS
    boxMesh box(labelVector(8, 8, 1), 2);
    const std::string text = someObjects::errorText
    (
        [&]()
        {
            fsi::objectWriter writer
            (
                box.time(), someObjects::dict("surface yes;"), 2
            );
        }
    );
    EXPECT_NE(text.find("'surface'"), std::string::npos) << text;
    EXPECT_NE(text.find("globalEvery"), std::string::npos) << text;
}


// ************************************************************************* //
