#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Suspensions of red cells: makes the cases and their table.

    suspension.py case FLOW PERCENT [NUMBER] [CROSSINGS] [FINER]
                                              cases/FLOW-PERCENT from case/
    suspension.py table                       table.md from what was run

FLOW is channel or shear. The mesh is FINER times as fine. Viscosities are over
that of the fluid alone, from the shear stress at the walls: over 6 rho nu U/H
in the channel, over 2 rho nu U/H in the shear box. Beside it that of the
channel's mean driving acceleration, G H^2/(12 nu U), with which it agrees in
the mean over time. The cell-free layer is the mean distance of the walls from
the nearest cell. All are means over the second half of a run.
"""

import math
import os
import re
import sys

import fsiCase
import results

HEIGHT_CELLS = 140

# Half the width of a cell [h], and its area over the square of that
RADIUS = 6
SHAPE_AREA = 0.8914

# Mean speed of the channel, speed of the shear box's walls [m/s]
SPEED = 1

VISCOSITY = 0.05

FOLDER = "cases"


def make(flow, percent, number=500, crossings=5, finer=1):
    """Writes a case with that many cells."""
    n, percent, crossings = int(number), float(percent), float(crossings)
    finer = int(finer)
    area = n*SHAPE_AREA*RADIUS**2
    nx = round(area/(percent/100)/HEIGHT_CELLS)
    length = nx/HEIGHT_CELLS
    end = crossings*length/SPEED
    path = os.path.join(FOLDER, f"{flow}-{percent:g}")
    fsiCase.copy("case", path)
    case_file(path, "system/size",
              nx=finer*nx, ny=finer*HEIGHT_CELLS, length=length, end=end,
              interval=end/20)
    case_file(path, "system/radius", radius=RADIUS/HEIGHT_CELLS)
    case_file(path, "system/number", number=n, minimumGap=1/HEIGHT_CELLS,
              wallGap=1/HEIGHT_CELLS)
    speed = SPEED if flow == "shear" else 0
    case_file(path, "0/walls", speed=speed, opposite=-speed)
    drive = ("" if flow == "shear" else
             f"drivingForce {{ type meanVelocity; velocity ({SPEED} 0 0); "
             "relaxationTime 0.1; }\n")
    with open(os.path.join(path, "constant/drive"), "w",
              encoding="ascii") as stream:
        stream.write(drive)
    print(path)


def case_file(path, name, **entries):
    """Writes entries to a file of a case."""
    with open(os.path.join(path, name), "w", encoding="ascii") as stream:
        stream.write("".join(f"{k} {v};\n" for k, v in entries.items()))


def entry(path, name):
    """A number of system/size."""
    text = results.read(path, "system/size")
    return float(re.search(rf"(?m)^{name} (\S+);", text).group(1))


def second_half(path):
    """Written times in the second half of the run."""
    times = results.times(path)
    return [t for t in times if float(t) > 0.5*float(times[-1])]


def wall_viscosity(path, flow):
    """From the gradient of the velocity between walls and first cells."""
    nx, ny = int(entry(path, "nx")), int(entry(path, "ny"))
    wall, plain = (SPEED, 2*SPEED) if flow == "shear" else (0, 6*SPEED)
    gradients = []
    for time in second_half(path):
        u = results.numbers(results.read(path, time, "U"),
                            "internalField")[::3]
        lower = abs(sum(u[:nx])/nx + wall)
        upper = abs(sum(u[nx*(ny - 1):])/nx - wall)
        gradients.append((lower + upper)*ny)
    return sum(gradients)/len(gradients)/plain


def driving_viscosity(path):
    """From the mean acceleration that the channel needs."""
    log = results.read(path, "log.fsiPisoFoam")
    steps = re.findall(r"(?m)^Time = (\S+)$|driving acceleration (\S+)$", log)
    drive = []
    time = 0
    for at, value in steps:
        if at:
            time = float(at)
        else:
            drive.append((time, float(value)))
    last = drive[-1][0]
    half = [value for at, value in drive if at > 0.5*last]
    return sum(half)/len(half)/(12*VISCOSITY*SPEED)


def free_layer(path):
    """Mean distance of the walls from the nearest cell, over columns h."""
    nx, length = int(entry(path, "nx")), entry(path, "length")
    sums = []
    for time in second_half(path):
        lower, upper = [1]*nx, [1]*nx
        for polygon in results.outlines(path, time).values():
            for (ax, ay), (bx, by) in results.edges(polygon):
                i = math.floor(0.5*(ax + bx)/length*nx) % nx
                lower[i] = min(lower[i], ay, by)
                upper[i] = min(upper[i], 1 - ay, 1 - by)
        sums.append((sum(lower) + sum(upper))/(2*nx))
    return sum(sums)/len(sums)


def row(path):
    """One line of the table."""
    flow, percent = os.path.basename(path).split("-")
    steps = results.table(path, "global.csv")
    driving = f"{driving_viscosity(path):.3f}" if flow == "channel" else ""
    seconds = sum(sum(v for k, v in r.items() if k.endswith("Seconds"))
                  for r in steps)/len(steps)
    crossings = steps[-1]["time"]*SPEED/entry(path, "length")
    return (f"| {flow} | {percent} % | {int(steps[-1]['objects'])} "
            f"| {crossings:.1f} | {wall_viscosity(path, flow):.3f} "
            f"| {driving} | {free_layer(path):.4f} "
            f"| {max(r['areaChange'] for r in steps):.1e} "
            f"| {len(steps)} | {seconds:.2f} |")


def table():
    """Writes table.md from all cases that were run."""
    lines = [
        "| flow | area fraction | cells | crossings | viscosity "
        "| from the drive | cell-free layer / H | change of area "
        "| steps | s per step |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for name in sorted(os.listdir(FOLDER)):
        path = os.path.join(FOLDER, name)
        if len(results.times(path)) > 2:
            lines.append(row(path))
    with open("table.md", "w", encoding="ascii") as stream:
        stream.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    {"case": make, "table": table}[sys.argv[1]](*sys.argv[2:])
