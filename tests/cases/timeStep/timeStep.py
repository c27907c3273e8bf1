#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A flow that starts from rest starts with deltaT, whatever maxDeltaT is, and
its steps grow by one place of their series at a time; those of a run that was
stopped go on as if it had not been. A fixed step that is too large is warned of
once; maxTimeError keeps the estimate of the error (doc/theory.md, (4.14)), as
it does in a run that was stopped.

    timeStep.py FOLDER
"""

import os
import re
import sys

import fsiCase
import results

DELTA_T, MAX_CO = 0.001, 0.3

# dt nu/h^2 = 41, where the mean velocity is some per cent off, and the error
# that maxTimeError allows
TOO_LARGE, MAX_ERROR = 0.04, 0.005


def numbers(pattern, log):
    """All numbers that follow a pattern at the head of a line."""
    return [float(x) for x in re.findall(rf"(?m)^{pattern}([0-9.e+-]+)", log)]


def holders(log):
    """Limits that held the step, by their numbers of steps."""
    line = re.search(r"(?m)^    time step .*held by (.*)$", log)
    found = re.findall(r"([\w ]+) \((\d+)\)", line.group(1) if line else "")
    return {name.strip(): int(number) for name, number in found}


def box(folder, name, **control):
    """A disc in a driven cavity."""
    return fsiCase.Case(
        os.path.join(folder, name), walls={"top": "(1 0 0)"},
        shapes="disc { shape { type circle; radius 0.15; }"
               " material { density 1; E 100; } }",
        placements="a { type listed; shape disc;"
                   " objects ({ centre (0.5 0.5 0); }); }",
        properties="output { log full; }",
        deltaT=DELTA_T, maxDeltaT=1, maxCo=MAX_CO, adjustTimeStep="yes",
        endTime=0.5, timePrecision=10, **control).set_up()


def check_start(report, folder):
    """The first steps."""
    log = box(folder, "rest", writeInterval=1000).run("fsiPisoFoam")
    steps = numbers("deltaT = ", log)
    courant = numbers("Courant Number fluid: ", log)
    report.check("it reaches its end", log.count("\nTime = ") == len(steps)
                 and abs(sum(steps) - 0.5) < 2*steps[-1], f"{sum(steps)} s")
    report.check("the first step is at most deltaT",
                 DELTA_T/2**0.25 <= steps[0] <= DELTA_T, f"{steps[0]} s")
    growth = max(b/a for a, b in zip(steps, steps[1:]))
    report.check("steps grow by a quarter of an octave",
                 1 < growth < 2**0.25*(1 + 1e-9), f"{growth}")
    report.check("the Courant number rises to its limit and stays there",
                 0.8*MAX_CO < max(courant) < 1.2*MAX_CO, f"{max(courant)}")
    held = holders(log)
    report.check("the summary tells that the step grew until maxCo held it",
                 set(held) == {"slow growth", "maxCo"}
                 and sum(held.values()) == len(steps), held)


def check_restart(report, folder):
    """The steps after each of the written times."""
    case = box(folder, "restarted", writeControl="adjustableRunTime",
               writeInterval=0.05)
    steps = numbers("deltaT = ", case.run("fsiPisoFoam"))
    same = 0
    starts = results.times(case.path)[1:-1]
    for start in starts:
        fsiCase.set_entry(os.path.join(case.path, "system/controlDict"),
                          "startFrom", "startTime")
        fsiCase.set_entry(os.path.join(case.path, "system/controlDict"),
                          "startTime", start)
        again = numbers("deltaT = ", case.run("fsiPisoFoam"))
        same += bool(again) and again == steps[-len(again):]
    report.check("steps go on as if the run had not been stopped",
                 len(starts) == 9 and same == len(starts),
                 f"after {same} of {len(starts)} stops")


def channel(folder, name, **control):
    """A disc that fills half of a channel in Stokes flow."""
    return fsiCase.Case(
        os.path.join(folder, name), viscosity=1, cyclic="x",
        properties="drivingForce { type acceleration; acceleration (12 0 0); }"
                   " output { log full; }",
        shapes="disc { shape { type circle; radius 0.25; }"
               " material { density 1; E 1e4; } }",
        placements="a { type listed; shape disc;"
                   " objects ({ centre (0.5 0.35 0); }); }",
        deltaT=TOO_LARGE, timePrecision=10, **control).set_up()


def errors(case):
    """The column timeError of global.csv."""
    return [row["timeError"] for row in results.table(case.path, "global.csv")]


def check_error(report, folder):
    """A fixed step that is too large, and one that follows its error."""
    case = channel(folder, "fixed", endTime=40*TOO_LARGE)
    log = case.run("fsiPisoFoam")
    report.check("a fixed step that is too large is warned of once",
                 log.count("The step is too large") == 1,
                 f"{log.count('The step is too large')} times")
    report.check("its steps are counted", "Time error above" in log)
    report.check("nothing held it", holders(log) == {}, holders(log))
    report.check("its error is seen", 0.02 < max(errors(case)[20:]) < 0.2,
                 f"{max(errors(case)[20:])}")

    case = channel(folder, "limited", endTime=1, adjustTimeStep="yes",
                   maxTimeError=MAX_ERROR, writeControl="adjustableRunTime",
                   writeInterval=0.5)
    log = case.run("fsiPisoFoam")
    found = errors(case)
    late = found[len(found)//2:]
    print(f"    {len(found)} steps, error {min(late):.3g} to {max(late):.3g}")
    report.check("the limit is kept", 0.1*MAX_ERROR < max(late)
                 < 1.3*MAX_ERROR, f"{max(late)}")
    held = holders(log)
    report.check("the summary names the limit",
                 held["maxTimeError"] > 0.5*len(found), held)
    report.check("no warning with the limit",
                 "The step is too large" not in log)
    before = numbers("Time error: ", log)
    case.control(startTime=0.5)
    after = numbers("Time error: ", case.run("fsiPisoFoam"))
    same = [abs(a - b) < 1e-4*b
            for a, b in zip(after, before[len(before) - len(after):])]
    report.check("a run that was stopped has the same errors",
                 0 < len(after) < len(before) and all(same),
                 f"in {sum(same)} of {len(after)} steps")


def check_rest(report, folder):
    """A disc as heavy as the fluid stays at rest: rounding is no error."""
    case = fsiCase.Case(
        os.path.join(folder, "still"), cells=(32, 32), density=1000,
        gravity="(0 -9.81 0)", endTime=0.3,
        shapes="disc { shape { type circle; radius 0.15; }"
               " material { density 1000; E 1e4; } }",
        placements="a { type listed; shape disc;"
                   " objects ({ centre (0.4 0.6 0); }); }").set_up()
    log = case.run("fsiPisoFoam")
    report.check("a flow at rest has no error",
                 "The step is too large" not in log
                 and max(errors(case)) < 1e-3, f"{max(errors(case))}")
    report.check("the log counts one pass", " passes 1 " in log,
                 log.splitlines()[-30:])


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("error", check_error, report, folder)
    report.attempt("rest", check_rest, report, folder)
    report.attempt("start", check_start, report, folder)
    report.attempt("restart", check_restart, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
