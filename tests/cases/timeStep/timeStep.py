#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A flow that starts from rest starts with deltaT, whatever maxDeltaT is, and
its steps grow by one place of their series at a time; those of a run that was
stopped go on as if it had not been.

    timeStep.py FOLDER
"""

import os
import re
import sys

import fsiCase
import results

DELTA_T, MAX_CO = 0.001, 0.3


def numbers(pattern, log):
    """All numbers that follow a pattern at the head of a line."""
    return [float(x) for x in re.findall(rf"(?m)^{pattern}([0-9.e+-]+)", log)]


def box(folder, name, **control):
    """A disc in a driven cavity."""
    return fsiCase.Case(
        os.path.join(folder, name), walls={"top": "(1 0 0)"},
        shapes="disc { shape { type circle; radius 0.15; }"
               " material { density 1; E 100; } }",
        placements="a { type listed; shape disc;"
                   " objects ({ centre (0.5 0.5 0); }); }",
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


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("start", check_start, report, folder)
    report.attempt("restart", check_restart, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
