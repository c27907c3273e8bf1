#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first tutorial to some time: surfaces never overlap, no object is lost,
areas stay, and the level set fits the surfaces.

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


def check_overlap_test(report):
    """The test of polygons sees overlap, touch and enclosure, and no more."""
    def square(x, y, a):
        return [(x, y), (x + a, y), (x + a, y + a), (x, y + a)]

    one = square(0, 0, 1)
    expected = [(square(0.9, 0.9, 1), True), (square(1, 0, 1), True),
                (square(0.4, 0.4, 0.1), True), (square(-1, -1, 3), True),
                (square(1 + 1e-12, 0, 1), False), (square(2, 2, 1), False)]
    wrong = [i for i, (other, answer) in enumerate(expected)
             if results.overlap(one, other) != answer
             or results.overlap(other, one) != answer]
    report.check("overlap test", not wrong, f"squares {wrong}")


def check_surfaces(report, case):
    """No overlap and none lost at any written time."""
    first = results.outlines(case, "0")
    overlaps, lost, out, change = [], [], [], 0
    times = results.times(case)
    for time in times:
        now = results.outlines(case, time)
        overlaps += [(time, *pair) for pair in results.overlapping(now)]
        lost += [(time, i) for i in first if i not in now]
        out += [(time, i) for i, p in now.items()
                if min(map(min, p)) < 0 or max(map(max, p)) > 1]
        change = max([change] + [
            abs(results.area(p)/results.area(first[i]) - 1)
            for i, p in now.items()])
    print(f"    {len(times)} times, {len(first)} objects, area change "
          f"{change:.1e}")
    report.check("surfaces do not overlap", not overlaps, f"{overlaps[:5]}")
    report.check("no object is lost", not lost, f"{lost[:5]}")
    report.check("all stay in the domain", not out, f"{out[:5]}")
    report.check("areas are kept at written times", change <= AREA_CHANGE,
                 f"{change:.2e}")
    return times


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
    check_overlap_test(report)
    case = report.attempt("tutorial runs", solve, folder, end)
    if case:
        check_surfaces(report, case)
        check_steps(report, case, end)


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
