#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first tutorial on several ranks gives the trajectories of one rank.

    ranks.py FOLDER STEPS
"""

import math
import os
import sys

import fsiCase
import results

DECOMPOSITIONS = {2: "(2 1 1)", 4: "(2 2 1)"}

# Of an object's size
TOLERANCE = 1e-8


def prepare(folder, steps):
    """The tutorial for some steps with tight tolerances, seeded."""
    case = fsiCase.tutorial(
        "lidDrivenCavity", os.path.join(folder, "serial"),
        endTime=0.005*steps, deltaT=0.005, adjustTimeStep="no",
        writeFormat="ascii", writeInterval=0.005*steps,
    )
    fsiCase.set_entry(os.path.join(case, "system/fvSolution"), "tolerance",
                      "1e-12")
    return case


def run_ranks(serial, ranks):
    """Decomposes a seeded case and runs it."""
    case = f"{serial}-{ranks}"
    fsiCase.shutil.copytree(serial, case, ignore=lambda _, names: [
        n for n in names if n.startswith(("log.", "postProcessing"))])
    dictionary = os.path.join(case, "system/decomposeParDict")
    fsiCase.set_entry(dictionary, "numberOfSubdomains", ranks)
    fsiCase.set_entry(dictionary, "n", DECOMPOSITIONS[ranks])
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
    """Centroid and size of each object, as a rank wrote them."""
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


def main(folder, steps):
    """The checks."""
    report = fsiCase.Report()
    serial = report.attempt("set-up", prepare, folder, steps)
    if serial is None:
        return

    cases = {n: report.attempt(f"{n} ranks run", run_ranks, serial, n)
             for n in DECOMPOSITIONS}
    if not report.attempt("one rank runs", solve, serial):
        return
    time = results.times(serial)[-1]
    expected = places(serial, "", time)
    print(f"    contacts up to "
          f"{max(r['contacts'] for r in results.table(serial, 'global.csv'))}")
    moved = difference(places(serial, "", "0"), expected)
    report.check("the objects move", moved > 0.01, f"by {moved:.2e} only")

    for n, case in cases.items():
        if case is None:
            continue
        found = [places(case, f"processor{r}", time) for r in range(n)]
        report.check(f"{n} ranks hold the same objects",
                     all(f == found[0] for f in found), "they differ")
        error = difference(expected, found[0])
        print(f"    {n} ranks: {error:.2e} of an object's size")
        report.check(f"{n} ranks give the trajectories of one",
                     error <= TOLERANCE, f"{error:.2e} of an object's size")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
