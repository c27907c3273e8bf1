#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The way in which the file of an outline lists its points changes nothing.

    outlines.py FOLDER

A rigid body with sharp corners, a few cells thick, moves in a box with a lid.
The points of its outline begin at another corner, and the case is its mirror
image, whose outline goes round the other way. No choice between the two faces
at a corner may depend on their numbers. The number of cells is odd, so that the
mirror keeps the colours of the sweeps.
"""

import os
import sys

import fsiCase
import results

# Of the largest value in the step
TOLERANCE = 1e-7

OUTLINE = ((0, 0), (0.22, 0.02), (0.24, 0.08), (0.09, 0.1), (0.1, 0.26),
           (0.02, 0.25))

STEPS = 40


def rows_of(folder, name, outline, side=1):
    """The rows of the body; side -1: of the mirror image, mirrored back."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(49, 49), deltaT=0.004,
        endTime=0.004*STEPS, writeInterval=STEPS,
        walls={"top": f"({side} 0 0)"}, gravity=f"({0.3*side:g} -1 0)",
        shapes='body { shape { type polygon; file "constant/body.csv"; } '
               "minimumCells 2; material { density 3; type rigid; } }",
        placements="a { type listed; shape body; objects ({ centre "
                   f"({0.5 - 0.05*side:g} 0.55 0); velocity ({0.5*side:g} 0.2 "
                   "0); rotation 0; }); }",
        properties="output { objectsEvery 1; }",
        p_tolerance=1e-13, U_tolerance=1e-13)
    case.text("constant/body.csv", "x,y\n" + "".join(
        f"{side*x!r},{y!r}\n" for x, y in outline))
    case.set_up()
    case.run("fsiPisoFoam")
    return [{"velocity": (side*row["velocityX"], row["velocityY"]),
             "force": (side*row["forceX"], row["forceY"]),
             "angular velocity": (side*row["angularVelocityZ"],)}
            for row in results.table(case.path, "objects.csv")]


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    first = rows_of(folder, "first", OUTLINE)
    others = {f"begins at point {i}": rows_of(
        folder, f"from{i}", OUTLINE[i:] + OUTLINE[:i]) for i in (1, 4)}
    others["mirror image"] = rows_of(folder, "mirror", OUTLINE, -1)
    for name, rows in others.items():
        for what in first[0]:
            worst = max(
                max(abs(a - b) for a, b in zip(one[what], two[what]))
                / max(abs(a) for a in one[what])
                for one, two in zip(first, rows))
            print(f"    {name}: {what} {worst:.1e} apart")
            report.check(f"outline, {name}: {what}",
                         len(rows) == STEPS == len(first)
                         and worst < TOLERANCE, f"{worst} apart")


if __name__ == "__main__":
    main(sys.argv[1])
