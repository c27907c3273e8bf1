#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first tutorial to some time: surfaces never overlap, no object is lost,
areas stay, the level set fits the surfaces, and the flow stays in its plane and
below twice the lid's speed.

    tutorial.py FOLDER END
"""

import os
import sys

import fsiCase
import results

AREA_CHANGE = 1e-3
MISFIT = 0.25
INTERVAL = 0.05


def solve(folder, end):
    """Runs the tutorial; the case folder."""
    seconds = {}
    case = fsiCase.tutorial(
        "lidDrivenCavity", os.path.join(folder, "case"),
        endTime=end, writeInterval=INTERVAL, writeFormat="ascii",
    )
    fsiCase.run(case, "fsiPisoFoam", limit=2000, seconds=seconds)
    print(f"    CPU time {seconds['fsiPisoFoam']:.0f} s")
    return case


def check_surfaces(report, case):
    """No overlap, none lost, areas kept at any written time."""
    text = report.attempt("objects are sound", fsiCase.run, case,
                          "checkObjects")
    if text:
        n = text.count("Time = ")
        print(f"    {n} times")
        report.check("objects are sound",
                     n == len(results.times(case)), f"{n} times checked")


def check_flow(report, case):
    """The largest components of the velocity, over all written times.
    Face normals have a rounding error in the direction that is not solved."""
    largest = [0, 0, 0]
    for time in results.times(case)[1:]:
        flat = results.field(case, time, "U")
        largest = [max(largest[i], *map(abs, flat[i::3])) for i in range(3)]
    print(f"    largest velocities {largest}")
    report.check("the flow stays in its plane", largest[2] < 1e-12,
                 f"{largest}")
    report.check("no cell is faster than the flow", max(largest) < 2,
                 f"{largest}")


def check_steps(report, case, end):
    """What global.csv says of every step."""
    rows = results.table(case, "global.csv")
    worst = {k: max(r[k] for r in rows)
             for k in ("areaChange", "misfit", "contacts")}
    smallest = min(r["smallestGap"] for r in rows)
    print(f"    {len(rows)} steps, {worst}, smallest gap {smallest:.2e}")
    report.check("runs to the end", abs(rows[-1]["time"] - end) < 1e-6,
                 f"time {rows[-1]['time']}")
    report.check("areas are kept at all steps",
                 worst["areaChange"] <= AREA_CHANGE, f"{worst}")
    report.check("the level set fits", worst["misfit"] < MISFIT, f"{worst}")
    report.check("gaps stay open", smallest > 0, f"{smallest}")
    report.check("objects come into contact", worst["contacts"] > 0, "never")


def main(folder, end):
    """The checks."""
    report = fsiCase.Report()
    case = report.attempt("tutorial runs", solve, folder, end)
    if case:
        check_surfaces(report, case)
        check_flow(report, case)
        check_steps(report, case, end)


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
