#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Function objects, -postProcess, -dry-run, formats of times, and what becomes
of objects that are seeded again."""

import os
import re
import sys

import fsiCase
import refused
import results
import stock

NAMES = {
    "wallShearStress": "libs (fieldFunctionObjects);",
    "vorticity": "libs (fieldFunctionObjects);",
    "Q": "libs (fieldFunctionObjects);",
    "CourantNo": "libs (fieldFunctionObjects);",
    "yPlus": "libs (fieldFunctionObjects);",
    "forces": "libs (forces); patches (top); rho rhoInf; rhoInf 1; "
              "CofR (0 0 0);",
    "scalarTransport": "libs (solverFunctionObjects); field s;",
}
LISTED = "functions { " + "".join(
    f"{name} {{ type {name}; writeControl writeTime; {more} }} "
    for name, more in NAMES.items()) + "}\n"


def with_functions(case, functions=LISTED):
    """The case, with function objects."""
    case.append("system/controlDict", functions)
    case.file("0/s", results.read(case.path, "0/p").split("\n", 9)[-1],
              "volScalarField")
    text = results.read(case.path, "system/fvSchemes")
    text = text.replace("div(phi,U)", "div(phi,s) Gauss upwind; div(phi,U)")
    with open(os.path.join(case.path, "system/fvSchemes"), "w",
              encoding="ascii") as stream:
        stream.write(text)
    stock.replace(case, "system/fvSolution", "p {", "s { solver PBiCGStab; "
                  "preconditioner DILU; tolerance 1e-6; } p {")
    return case


def functions(report, folder):
    """They find the fluid; those of a run and those after it agree."""
    case = with_functions(stock.new_case(folder))
    log = case.run("fsiPisoFoam")
    lost = [line for line in log.split("\n") if "nable to find" in line]
    stress = results.numbers(
        re.search(r"top\s*\{.*?\}", results.read(
            folder, "0.02/wallShearStress"), re.S).group().replace(
                "value", "\nvalue"), "value")
    # nu u/y of the lid over the first cells, at the middle; OpenFOAM's gradient
    # at a wall has along it that of the cell, here of the velocity across
    u = results.field(folder, "0.02", "U")
    expected = 0.01*((1 - u[3*390])/0.025 + (u[3*391 + 1] - u[3*389 + 1])/0.1)
    report.check("habits.wallShearStress", not lost and abs(
        abs(stress[30]) - expected) < 1e-9, f"{stress[30]}, not {expected}")
    os.remove(os.path.join(folder, "0.02/wallShearStress"))
    log = fsiCase.run(folder, "fsiPisoFoam", "-postProcess", "-func",
                      "wallShearStress", "-latestTime")
    report.check("habits.postProcess", os.path.exists(
        os.path.join(folder, "0.02/wallShearStress")), log[-500:])


def dry_run(report, folder):
    """A step that leaves nothing behind."""
    case = stock.new_case(folder, endTime=10, writeInterval=1)
    before = sorted(os.listdir(folder))
    log = case.run("fsiPisoFoam", "-dry-run")
    left = set(os.listdir(folder)) - set(before)
    report.check("habits.dryRun", "No time is written" in log and
                 left <= {"log.fsiPisoFoam", "postProcessing-dry-run"},
                 f"{left}")


def formats(report, folder):
    """timeFormat is another one than that of the folder 0."""
    for name in ("fixed", "scientific"):
        case = stock.new_case(os.path.join(folder, name), timeFormat=name,
                              timePrecision=4, startFrom="latestTime")
        seeded = results.times(case.path)
        case.run("fsiPisoFoam")
        case.control(endTime=0.04)
        log = case.run("fsiPisoFoam")
        case.run("checkObjects")
        times = results.times(case.path)
        report.check(f"habits.timeFormat.{name}", seeded == ["0"]
                     and len(times) == 3 and "incomplete" not in log,
                     f"{seeded}, then {times}")


def of_functions(report, folder):
    """Times of function objects alone are no times of the run."""
    case = stock.new_case(folder, startFrom="latestTime", writeInterval=2)
    case.append("system/controlDict", "functions { vorticity { type vorticity;"
                " libs (fieldFunctionObjects); writeControl timeStep;"
                " writeInterval 1; } }\n")
    case.run("fsiPisoFoam")
    fsiCase.set_entry(os.path.join(folder, "system/controlDict"),
                      "endTime", 0.025)
    case.run("fsiPisoFoam")
    fsiCase.set_entry(os.path.join(folder, "system/controlDict"),
                      "endTime", 0.03)
    log = case.run("fsiPisoFoam")
    names = os.listdir(folder)
    report.check("habits.timesOfFunctions", "incomplete" not in log
                 and "0.025" in names and "Time = 0.025" in log
                 and "0.03" in names, f"{sorted(names)}")
    log = case.run("checkObjects")
    report.check("habits.checkObjects", "0.005: no objects" in log
                 and "0.02: no" not in log, log[-500:])


def seeded_again(report, folder):
    """A run's objects are not dropped; seeds that did not run are replaced."""
    case = stock.new_case(folder, startFrom="latestTime")
    case.run("seedObjects")
    case.run("fsiPisoFoam")
    refused.refused(report, "habits.seededAgain", case, "seedObjects",
                    ["0.02", "1 objects of a run", "startFrom"])
    case.control(startFrom="startTime")
    case.run("seedObjects")


def falling(report, folder):
    """In a periodic box gravity needs a balance, as no mean flow."""
    options = {"cyclic": "xy", "walls": {}, "startFrom": "latestTime"}
    case = stock.new_case(os.path.join(folder, "free"), **options)
    warned = "ever faster" in case.run("fsiPisoFoam")
    case = stock.new_case(
        os.path.join(folder, "balanced"), deltaT=0.01, writeInterval=10,
        writePrecision=17, properties="drivingForce { type meanVelocity;"
        " velocity (0 0 0); }", **{**options, "endTime": 0.2})
    log = case.run("fsiPisoFoam")
    case.control(endTime=0.4)
    log += case.run("fsiPisoFoam")
    U = results.field(case.path, "0.4", "U")
    speeds = [sum(U[d::3])/len(U[d::3]) for d in (0, 1)]
    rows = results.table(case.path, "objects.csv")
    report.check("habits.free", warned, "no warning")
    report.check("habits.noMeanFlow", "ever faster" not in log
                 and max(map(abs, speeds)) < 1e-3
                 and rows[-1]["velocityY"] < -0.02,
                 f"mean {speeds}, disc {rows[-1]['velocityY']}")


def main():
    report = fsiCase.Report()
    parts = [formats, seeded_again, falling]
    if os.environ.get("FSI_LINE") != "foundation":
        parts += [functions, dry_run, of_functions]
    for part in parts:
        report.attempt(part.__name__, part, report,
                       os.path.join(sys.argv[1], part.__name__))
    return report.failures > 0


if __name__ == "__main__":
    sys.exit(main())
