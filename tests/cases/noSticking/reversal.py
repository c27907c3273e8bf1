#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two soft cells between walls that shear the fluid are pushed together, over
one another; then the walls turn. Cells that do not stick go back the way they
came: contact ends, and in the end they are as far apart as at the start.

    reversal.py FOLDER
"""

import math
import os
import sys

import fsiCase
import results

TURN, END = 1.4, 2.8
H = 1/40

SHAPES = """
cell
{
    shape { type ellipse; semiAxes (0.13 0.09); }
    material { density 1; E 5; }
}
"""
PLACEMENTS = """
cells
{
    type listed; shape cell;
    objects ({ centre (0.83 0.56 0); } { centre (1.17 0.44 0); });
}
"""
# Entries of fsiProperties
CONTACT = {
    "default": "",
}
FIELD = """dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{{
    top    {{ type uniformFixedValue; uniformValue table
             ((0 (1 0 0)) ({0} (1 0 0)) ({1} (-1 0 0)) (10 (-1 0 0))); }}
    bottom {{ type uniformFixedValue; uniformValue table
             ((0 (-1 0 0)) ({0} (-1 0 0)) ({1} (1 0 0)) (10 (1 0 0))); }}
    left   {{ type fixedValue; value uniform (0 0 0); }}
    right  {{ type fixedValue; value uniform (0 0 0); }}
    frontAndBack {{ type empty; }}
}}
"""


def solve(folder, name):
    """Runs a case with these entries of contact; its folder."""
    case = fsiCase.Case(
        os.path.join(folder, name.replace(" ", "")), box=(0, 0, 2, 1),
        cells=(80, 40), viscosity=0.1, shapes=SHAPES, placements=PLACEMENTS,
        properties=CONTACT[name], deltaT=0.005, endTime=END,
        writeInterval=20, timePrecision=6,
    )
    case.file("0/U", FIELD.format(TURN, TURN + 1e-6), "volVectorField")
    case.set_up()
    case.run("fsiPisoFoam", limit=1500)
    case.run("checkObjects")
    return case.path


def distance(case, time):
    """Distance of the centroids, and which is on the left."""
    rows = [r for r in results.table(case, "objects.csv")
            if abs(r["time"] - time) < 1e-6]
    (x0, y0), (x1, y1) = ((r["centroidX"], r["centroidY"]) for r in rows)
    return math.hypot(x1 - x0, y1 - y0)


def check(report, case, name):
    """Pushed together, and apart again."""
    rows = results.table(case, "global.csv")
    smallest = min(r["smallestGap"] for r in rows)
    touched = [r["time"] for r in rows if r["contacts"] > 0]
    last = max(touched, default=0)
    first, apart = distance(case, 0.1), distance(case, END)
    print(f"    {name}: smallest gap {smallest/H:.2f} h, in contact from "
          f"{min(touched, default=0):.2f} to {last:.2f}, distance "
          f"{first:.4f} and {apart:.4f}")
    report.check(f"the flow pushes them together, {name}",
                 touched and min(touched) < TURN, "no contact")
    report.check(f"surfaces never meet, {name}", smallest > 0, f"{smallest}")
    report.check(f"contact ends after the turn, {name}",
                 last < END - 0.1, f"{last}")
    report.check(f"they part, {name}", apart > 0.8*first,
                 f"{apart} after {first}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for name in CONTACT:
        case = report.attempt(f"run, {name}", solve, folder, name)
        if case:
            report.attempt(f"results, {name}", check, report, case, name)


if __name__ == "__main__":
    main(sys.argv[1])
