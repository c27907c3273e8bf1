#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first tutorial, and membranes in a periodic channel, on several ranks
give the trajectories of one rank.

    ranks.py FOLDER STEPS       of the first; a tenth of that for the membranes
"""

import math
import os
import sys

import fsiCase
import results

# Time step, part of the steps, decomposition by number of ranks
RUNS = {
    "lidDrivenCavity": (0.005, 1, {2: "(2 1 1)", 4: "(2 2 1)"}),
    "redCells": (5e-5, 0.1, {2: "(2 1 1)", 4: "(2 2 1)"}),
}

# Of an object's size
TOLERANCE = 1e-8


def prepare(folder, tutorial, step, end):
    """The tutorial with a fixed step and tight tolerances, seeded."""
    case = fsiCase.tutorial(
        tutorial, os.path.join(folder, tutorial),
        endTime=end, deltaT=step, adjustTimeStep="no",
        writeFormat="ascii", writeInterval=end,
    )
    fsiCase.set_entry(os.path.join(case, "system/fvSolution"), "tolerance",
                      "1e-12")
    return case


def run_ranks(serial, ranks, parts):
    """Decomposes a seeded case and runs it."""
    case = f"{serial}-{ranks}"
    fsiCase.shutil.copytree(serial, case, ignore=lambda _, names: [
        n for n in names if n.startswith(("log.", "postProcessing"))])
    dictionary = os.path.join(case, "system/decomposeParDict")
    fsiCase.set_entry(dictionary, "numberOfSubdomains", ranks)
    fsiCase.set_entry(dictionary, "n", parts)
    seconds = {}
    fsiCase.run(case, "decomposePar")
    fsiCase.run(case, "fsiPisoFoam", ranks=ranks, limit=2000, seconds=seconds)
    print(f"    CPU time on {ranks} ranks {seconds['fsiPisoFoam']:.0f} s")
    return case


def solve(case):
    """Runs a case on one rank."""
    seconds = {}
    fsiCase.run(case, "fsiPisoFoam", limit=2000, seconds=seconds)
    print(f"    CPU time {seconds['fsiPisoFoam']:.0f} s")
    return True


def places(case, rank, time):
    """Centroid and size of each object, as the first rank wrote them."""
    found = {}
    for i, polygon in results.outlines(case, time, rank).items():
        size = math.sqrt(abs(results.area(polygon)))
        found[i] = results.centroid(polygon), size
    return found


def difference(one, other):
    """Largest distance of centroids over the objects' size."""
    if sorted(one) != sorted(other):
        raise ValueError(f"objects {sorted(other)}, not {sorted(one)}")
    return max(math.dist(one[i][0], other[i][0])/one[i][1] for i in one)


def check(report, folder, tutorial, steps):
    """The checks of a tutorial."""
    step, share, decompositions = RUNS[tutorial]
    serial = report.attempt("set-up", prepare, folder, tutorial, step,
                            step*round(share*steps))
    if serial is None:
        return

    cases = {n: report.attempt(f"{n} ranks run", run_ranks, serial, n, parts)
             for n, parts in decompositions.items()}
    if not report.attempt("one rank runs", solve, serial):
        return
    time = results.times(serial)[-1]
    expected = places(serial, "", time)
    print(f"    contacts up to "
          f"{max(r['contacts'] for r in results.table(serial, 'global.csv'))}")
    moved = difference(places(serial, "", "0"), expected)
    report.check(f"{tutorial}: the objects move", moved > 0.01,
                 f"by {moved:.2e} only")

    for n, case in cases.items():
        if case is None:
            continue
        error = difference(expected, places(case, "processor0", time))
        print(f"    {n} ranks: {error:.2e} of an object's size")
        report.check(f"{tutorial}: {n} ranks give the trajectories of one",
                     error <= TOLERANCE, f"{error:.2e} of an object's size")


def main(folder, steps):
    """The checks of all."""
    report = fsiCase.Report()
    for tutorial in RUNS:
        check(report, folder, tutorial, steps)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
