#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorial poiseuille: the fluid starts with the profile that
setExprFields gives it, the inlet keeps the one of its boundary condition,
and the flow upstream of the discs stays a parabola.

    profile.py FOLDER
"""

import os
import shutil
import sys

import fsiCase
import results

TUTORIAL = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "../../../tutorials/poiseuille")
NX, NY = 96, 32

INLETS = {
    "fixedProfile": None,
    "exprFixedValue":
        'type exprFixedValue; value uniform (0 0 0); valueExpr '
        '"vector(6*pos().y()*(1 - pos().y()), 0, 0)";',
    "codedFixedValue": """type codedFixedValue; value uniform (0 0 0);
        name parabola; code
        #{
            const scalarField y(patch().Cf().component(vector::Y));
            operator==(6*y*(1 - y)*vector(1, 0, 0));
        #};""",
}


def parabola(row):
    """Velocity in the middle of a row of cells."""
    y = (row + 0.5)/NY
    return 6*y*(1 - y)


def solve(case, inlet, end):
    """The tutorial with another condition at the inlet."""
    shutil.copytree(TUTORIAL, case, ignore=shutil.ignore_patterns(
        "[1-9]*", "0", "0.[0-9]*", "log.*", "postProcessing", "polyMesh"))
    os.rename(os.path.join(case, "0.orig"), os.path.join(case, "0"))
    if inlet:
        path = os.path.join(case, "0/U")
        text = results.read(path)
        start = text.index("{", text.index("\n    inlet")) + 1
        with open(path, "w", encoding="ascii") as stream:
            stream.write(text[:start] + inlet
                         + text[text.index("    }\n    outlet"):])
    control = os.path.join(case, "system/controlDict")
    fsiCase.set_entry(control, "endTime", end)
    fsiCase.set_entry(control, "writeInterval", end)
    for program in ("blockMesh", "setExprFields", "seedObjects",
                    "fsiPisoFoam"):
        fsiCase.run(case, program)
    return case


def upstream(case, time, column):
    """Velocities along x of a column of cells."""
    values = results.numbers(results.read(case, time, "U"),
                             "internalField")[::3]
    return [values[NX*row + column] for row in range(NY)]


def check(report, name, case, end):
    """The start, and the flow beside the inlet at the end."""
    worst = max(abs(u - parabola(row))
                for row, u in enumerate(upstream(case, "0", NX//2)))
    report.check(f"{name}: the fluid starts with the profile", worst < 1e-5,
                 worst)
    # Differences over a cell at the walls leave 1.5 h^2 = 0.0015; the discs,
    # 0.9 heights from here, some exp(-pi 0.9) of what they are slower by
    worst = max(abs(u - parabola(row))
                for row, u in enumerate(upstream(case, end, 2)))
    report.check(f"{name}: the inflow stays a parabola", worst < 0.02, worst)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for name, inlet in INLETS.items():
        if name == "codedFixedValue" and os.geteuid() == 0:
            print("    codedFixedValue: OpenFOAM refuses it to root")
            continue
        case = os.path.join(folder, name)
        end = "1" if inlet is None else "0.02"
        if report.attempt(f"{name}, run", solve, case, inlet, end):
            check(report, name, case, end)
            try:
                fsiCase.run(case, "checkObjects")
                report.check(f"{name}: the objects are sound", True)
            except RuntimeError as error:
                report.check(f"{name}: the objects are sound", False,
                             str(error))


if __name__ == "__main__":
    main(sys.argv[1])
