#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Three ranks in a row, of which the middle one has two neighbours and the
others one, and three of which one has no cells, give the objects of one rank.
So do two where a periodic square has an odd number of cells, and four and six
ranks where objects touch and go from one to the other, and three where discs
are dense and steps long. A restart on three ranks is the run without a stop to
the last bit.

    threeRanks.py FOLDER
"""

import math
import os
import sys

import anyRanks
import fsiCase
import results
import smallCase


def check_restart(report, folder):
    """Four steps and four more are eight."""
    states = []
    for name, ends in (("whole", (0.04,)), ("parts", (0.02, 0.04))):
        case = anyRanks.channel(os.path.join(folder, name))
        n_ranks = anyRanks.decompose(case, (3, 1, 1))
        for end in ends:
            case.control(endTime=end)
            case.run("fsiPisoFoam", ranks=n_ranks)
        states.append([smallCase.result(
            os.path.join(case.path, f"processor{rank}", "0.04"))
            for rank in range(n_ranks)])
    report.check("the first rank alone writes the state",
                 ["uniform/fsiPopulation" in state for state in states[0]]
                 == [True, False, False], [list(s) for s in states[0]])
    for rank, (whole, parts) in enumerate(zip(*states)):
        differ = [name for name in sorted(set(whole) | set(parts))
                  if whole.get(name) != parts.get(name)]
        report.check(f"a restart is bitwise the same on rank {rank}",
                     whole and not differ, differ)


def check_more_ranks(report, folder):
    """A run on one rank goes on on three, which cut the cyclic sides."""
    ends = []
    for name, n in (("one", 1), ("more", 3)):
        case = fsiCase.Case(
            os.path.join(folder, name), cells=(24, 24), cyclic="xy",
            velocity="(1 0.5 0)", shapes=smallCase.SHAPES,
            placements=smallCase.PLACEMENTS, deltaT=0.005, endTime=0.02,
            writeInterval=4, writePrecision=17, startFrom="latestTime",
            p_tolerance=1e-11, U_tolerance=1e-12).set_up()
        case.run("fsiPisoFoam")
        case.control(endTime=0.04)
        if n > 1:
            case.decompose(n, 1)
        case.run("fsiPisoFoam", ranks=n)
        if n > 1:
            case.run("reconstructPar", "-latestTime")
        ends.append(results.state(case.path, "0.04"))
    error = max(math.dist(p, q) for i in ends[0]
                for p, q in zip(ends[0][i][1], ends[1][i][1]))
    report.check("a run goes on on more ranks", error < 1e-10, f"{error:.1e}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("ranks", anyRanks.compare, report, folder,
                   anyRanks.channel, [(3, 1, 1), "hollow"])
    report.attempt("odd", anyRanks.compare, report, folder, anyRanks.odd,
                   [(1, 2, 1)])
    report.attempt("crowd", anyRanks.compare, report, folder,
                   anyRanks.crowd, [(2, 2, 1), (3, 2, 1)])
    report.attempt("dense", anyRanks.compare, report, folder,
                   anyRanks.dense, [(3, 1, 1)])
    report.attempt("restart", check_restart, report, folder)
    report.attempt("more ranks", check_more_ranks, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
