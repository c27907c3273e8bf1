#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorial redCells in SI units and in micrometres, milliseconds and
nanograms is the same run: nothing in it depends on a length of its own.

    units.py FOLDER

All solvers have relative tolerances, of 1e-9 here: what they leave is not the
same in other units, and cells near to each other enlarge it.
"""

import math
import os
import re
import sys

import fsiCase
import results

TUTORIAL = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "../../../tutorials/redCells")
END, STEPS = 2.5e-3, 50

# um, ms, ng
LENGTH, TIME, MASS = 1e6, 1e3, 1e12

# Files, entries, and powers of length, time and mass of their units
ENTRIES = (
    ("system/blockMeshDict", "scale", (1, 0, 0)),
    ("system/controlDict", "endTime", (0, 1, 0)),
    ("system/controlDict", "deltaT", (0, 1, 0)),
    ("system/controlDict", "maxDeltaT", (0, 1, 0)),
    ("system/controlDict", "writeInterval", (0, 1, 0)),
    ("system/seedObjectsDict", "radius", (1, 0, 0)),
    ("system/seedObjectsDict", "density", (-3, 0, 1)),
    ("system/seedObjectsDict", "shearModulus", (0, -2, 1)),
    ("system/seedObjectsDict", "bendingModulus", (2, -2, 1)),
    ("system/seedObjectsDict", "innerViscosity", (-1, -1, 1)),
    ("system/seedObjectsDict", "minimumGap", (1, 0, 0)),
    ("system/seedObjectsDict", "wallGap", (1, 0, 0)),
    ("constant/transportProperties", r"nu *\[.*\]", (2, -1, 0)),
    ("constant/fsiProperties", "fluidDensity", (-3, 0, 1)),
    ("constant/fsiProperties", r"velocity *\(", (1, -1, 0)),
)


def convert(case):
    """All entries in the other units."""
    for name, key, (length, time, mass) in ENTRIES:
        path = os.path.join(case, name)
        with open(path, encoding="ascii") as stream:
            text = stream.read()
        factor = LENGTH**length*TIME**time*MASS**mass
        text, count = re.subn(
            rf"(?m)^( *{key} *)([0-9.e+-]+)",
            lambda m, f=factor: f"{m.group(1)}{float(m.group(2))*f!r}", text)
        if count != 1:
            raise RuntimeError(f"{count} entries {key} in {name}")
        with open(path, "w", encoding="ascii") as stream:
            stream.write(text)


def solve(case, other):
    """Runs the tutorial; centroids of its objects at the end, and the log."""
    fsiCase.copy(TUTORIAL, case)
    control = os.path.join(case, "system/controlDict")
    fsiCase.set_entry(control, "endTime", END)
    fsiCase.set_entry(control, "writeInterval", END)
    solution = os.path.join(case, "system/fvSolution")
    with open(solution, encoding="ascii") as stream:
        text = stream.read()
    with open(solution, "w", encoding="ascii") as stream:
        stream.write(re.sub(r"(tolerance +)1e-[68];", r"\g<1>1e-9;", text))
    if other:
        convert(case)
    fsiCase.run(case, "blockMesh")
    fsiCase.run(case, "seedObjects")
    log = fsiCase.run(case, "fsiPisoFoam")
    rows = results.table(case, "objects.csv")
    last = [r for r in rows if r["time"] == rows[-1]["time"]]
    return {r["object"]: (r["centroidX"], r["centroidY"]) for r in last}, log


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    metres, log = solve(os.path.join(folder, "metres"), False)
    report.check("50 steps in which all sweeps converge",
                 log.count("\nTime = ") == STEPS
                 and "did not converge" not in log, log.count("\nTime = "))
    other = solve(os.path.join(folder, "micrometres"), True)[0]
    worst = max(math.dist(metres[i], [x/LENGTH for x in other[i]])
                for i in metres)
    # The cells go 2 um, and the radius is 3.9 um
    report.check("centroids are the same in other units",
                 len(metres) == len(other) == 18 and worst < 2e-6*3.9e-6,
                 f"{worst/3.9e-6} radii")
    print(f"    centroids differ by {worst/3.9e-6:.1e} radii")


if __name__ == "__main__":
    main(sys.argv[1])
