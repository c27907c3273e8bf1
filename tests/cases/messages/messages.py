#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""No message of a step has a size that grows with the number of all objects:
two ranks with the same objects at the cut between them and four times as many
elsewhere send messages of the same sizes. At the start the first rank reads the
state of all objects and sends each other rank what that one owns.

    messages.py FOLDER
"""

import os
import sys

import countMessages
import fsiCase
import results

# Cells and objects to a unit of length
CELLS = 48
OBJECTS = 4

# Steps at the start that are not counted
WARM_UP = 2

# Bytes of other messages at the start: the shape, the mesh
START = 1e5

SOLVERS = """solvers
{
    p { solver cartesianMG; tolerance 1e-6; relTol 0; gatherCells 500; }
    U { solver PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0; }
}
PISO {}
"""


def build(path, length):
    """Discs in a periodic box of this length, cut in the middle. They touch
    and are on the cuts."""
    spacing = 1/OBJECTS
    centres = " ".join(
        f"{{ centre ({(i + 0.6)*spacing:.6g} {(j + 0.5)*spacing:.6g} 0); "
        f"velocity (1 {0.5*(-1)**(i + j)} 0); }}"
        for i in range(length*OBJECTS) for j in range(OBJECTS))
    case = fsiCase.Case(
        path, box=(0, 0, length, 1), cells=(length*CELLS, CELLS),
        cyclic="xy", density=1000, viscosity=0.01, velocity="(1 0 0)",
        shapes="disc { shape { type circle; radius 0.11; } "
               "material { density 1000; E 2e4; } }",
        properties="driving { type meanVelocity; velocity (1 0 0); }\n",
        placements="all { type listed; shape disc; objects "
                   f"({centres}); }}",
        deltaT=0.004, endTime=0.0321, writeInterval=100, timePrecision=10,
        libs='("libFastPoisson.so")')
    case.file("system/fvSolution", SOLVERS)
    case.set_up()
    case.decompose(2, 1, 1)
    return case


def sizes(report, folder, length):
    """Largest message from rank to rank, largest collective one, and bytes of
    a message on average, in bytes."""
    case = build(os.path.join(folder, str(length)), length)
    ranks = countMessages.counted(case, 2, countMessages.library(folder))
    # 8 bytes for each number of all objects; one of two ranks gets half
    state = os.path.join(case.path, "processor0/0/uniform/fsiObjects/disc")
    numbers = len(results.read(state).split())
    sent = ranks[0][0]["bytes"]
    report.check("the first rank sends the state of an object to its owner",
                 sent < 8*numbers + START, f"{sent:.0f}, {8*numbers} B")
    rows = [row for rank in ranks for row in rank[1 + WARM_UP:]]
    largest = max(row["largest"] for row in rows)
    collective = max(row["largestCollective"] for row in rows)
    mean = sum(row["bytes"] for row in rows)/sum(row["messages"]
                                                 for row in rows)
    print(f"    {length*OBJECTS**2} objects: {largest:.0f}, {collective:.0f}, "
          f"{mean:.0f} B")
    return largest, collective, mean


def compare(report, folder):
    """Box and longer box."""
    few, many = sizes(report, folder, 2), sizes(report, folder, 8)
    for name, short, long in zip(("largest message", "largest collective one",
                                  "mean message"), few, many):
        report.check(f"the {name} does not grow", 0 < long < 1.1*short,
                     f"{short:.0f}, {long:.0f} bytes")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("sizes", compare, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
