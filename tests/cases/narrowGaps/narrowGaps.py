#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow through a narrow gap between two fixed plates. Its mean velocity is
G g^2/(12 nu), for a gap g and the force G less the pressure gradient, however
the gap lies in the mesh, and whatever the force comes from.

    narrowGaps.py FOLDER

A gap of a film (theory.md, (5.29)) has this flow to 1 %. Without films it is
1 + 2/n^2 times as large in a gap of n cells, 1.22 with three.
"""

import os
import sys

import fsiCase
import results
from scalarCase import ScalarCase

CELLS = 32
H = 1/CELLS
FORCE = 1e-3
LENGTH, THICKNESS = 0.5, 0.15

DRIVE = {
    "acceleration": {"properties": "drivingForce { type acceleration; "
                      f"acceleration ({FORCE} 0 0); }}"},
    "fvOptions": {},
    "buoyancy": {"gravity": "(-1 0 0)"},
}

OPTIONS = f"""drive
{{
    type vectorSemiImplicitSource;
    selectionMode all;
    volumeMode specific;
    injectionRateSuSp {{ U (({FORCE} 0 0) 0); }}
}}
"""


def flow(folder, gap, place, drive, step=1, ranks=1):
    """Flow through the gap, in cells, over the exact one; the middle of the
    gap lies beside a face of the mesh by place, in cells; the step is in
    h^2/nu."""
    middle = 0.5 + place*H
    away = (gap*H + THICKNESS)/2
    end = 30*(gap*H)**2
    parameters = dict(DRIVE[drive])
    parameters["properties"] = (parameters.get("properties", "")
                                + " contact { law { type none; } }")
    scalars = ((("T", "diffusivity 1; buoyancy { expansion "
                 f"{FORCE}; }}", "uniform 1", {}),)
               if drive == "buoyancy" else ())
    case = ScalarCase(
        os.path.join(folder, f"{drive}-{gap}-{place}-{step}-{ranks}"), scalars,
        cells=(CELLS, CELLS), viscosity=1, cyclic="xy", deltaT=step*H**2,
        endTime=end, writeInterval=end, writeControl="adjustableRunTime",
        adjustTimeStep="no", timePrecision=12,
        shapes='plate { shape { type polygon; file "plate.csv"; } material '
               "{ type rigid; density 1; } motion { type fixed; } }",
        placements="a { type listed; shape plate; objects "
                   f"({{ centre (0.5 {middle - away} 0); }} "
                   f"{{ centre (0.5 {middle + away} 0); }}); }}",
        **parameters)
    with open(os.path.join(case.path, "plate.csv"), "w",
              encoding="ascii") as stream:
        stream.write("x,y\n")
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            stream.write(f"{x*LENGTH/2},{y*THICKNESS/2}\n")
    if drive == "fvOptions":
        case.file("constant/fvOptions", OPTIONS)
    case.set_up()
    if ranks > 1:
        case.decompose(ranks, 1)
    case.run("fsiPisoFoam", ranks=ranks)
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    return through(case.path, gap, middle)


def through(path, gap, middle):
    """The flow of the last time over the exact one."""
    time = results.times(path)[-1]
    phi = results.field(path, time, "phi")
    p = results.field(path, time, "p")
    # Internal faces in the order of their cells, to x and then to y
    flux = face = 0
    for j in range(CELLS):
        for i in range(CELLS):
            if i + 1 < CELLS:
                near = abs((j + 0.5)*H - middle) < (gap/2 + 1)*H
                flux += phi[face] if near and i + 1 == CELLS//2 else 0
                face += 1
            face += j + 1 < CELLS
    cell = int(middle/H)*CELLS + CELLS//2
    force = FORCE - (p[cell + 4] - p[cell - 5])/(9*H)
    return flux/H/(force*(gap*H)**3/12)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for gap in (0.6, 1.2, 2, 2.4):
        for place in (0, 0.37):
            found = flow(folder, gap, place, "acceleration")
            report.check(f"gap of {gap} cells, {place}",
                         abs(found - 1) < 0.01, found)
    for step in (0.1, 10):
        found = flow(folder, 2, 0.37, "acceleration", step)
        report.check(f"steps of {step}", abs(found - 1) < 0.01, found)
    # A scalar's force is known in cells with their centres in the fluid
    for drive, place in (("fvOptions", 0.37), ("buoyancy", 0)):
        found = flow(folder, 2, place, drive)
        report.check(drive, abs(found - 1) < 0.01, found)
        other = flow(folder, 2, place, drive, ranks=2)
        report.check(f"{drive}, 2 ranks", abs(other - found) < 1e-6, other)


if __name__ == "__main__":
    main(sys.argv[1])
