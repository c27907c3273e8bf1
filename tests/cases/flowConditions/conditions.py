#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary conditions of OpenFOAM that the user's guide names: a uniform flow
with a disc that it carries stays uniform under each of them, and a total
pressure at the inlet speeds fluid and disc up as Bernoulli's equation says.

    conditions.py FOLDER
"""

import math
import os
import sys

import fsiCase
import results
from openChannel import OPEN, PLUG, channel

LENGTH, DEPTH = 2, 2/48

# At the inlet, at the outlet: condition of U and of p; None: as in openChannel
CONDITIONS = {
    "uniformFixedValue": (
        ("type uniformFixedValue; uniformValue constant (1 0 0);",
         "type zeroGradient;"), None),
    "uniformFixedValue, a table": (
        ("type uniformFixedValue; uniformValue table ((0 (1 0 0)) "
         "(10 (1 0 0)));", "type zeroGradient;"), None),
    "flowRateInletVelocity": (
        (f"type flowRateInletVelocity; volumetricFlowRate {DEPTH}; "
         "value uniform (1 0 0);", "type zeroGradient;"), None),
    "inletOutlet": (
        None, ("type inletOutlet; inletValue uniform (0 0 0); "
               "value uniform (1 0 0);",
               "type fixedValue; value uniform 0;")),
    "advective": (
        None, ("type advective; value uniform (1 0 0);",
               "type fixedValue; value uniform 0;")),
    "uniformFixedValue of p": (
        None, ("type zeroGradient;",
               "type uniformFixedValue; uniformValue constant 0;")),
    "pressureInletOutletVelocity": (
        None, ("type pressureInletOutletVelocity; value uniform (1 0 0);",
               "type fixedValue; value uniform 0;")),
    "outletInlet of p": (
        None, ("type zeroGradient;", "type outletInlet; "
               "outletValue uniform 0; value uniform 0;")),
    "symmetry": (None, None),
    "symmetryPlane": (None, None),
    "slip": (None, None),
}


def solve(folder, name, inlet, outlet, **parameters):
    """Runs a channel; the case."""
    case = channel(folder, name.replace(" ", "_").replace(",", ""),
                   ((0.5, 0.47, parameters.pop("speed", 1)),), walls=PLUG,
                   open={"left": inlet or OPEN["left"],
                         "right": outlet or OPEN["right"]},
                   endTime=0.1, writeInterval=10, **parameters)
    kind = name.split(",")[0]
    if kind in ("symmetry", "symmetryPlane", "slip"):
        slide(case.path, kind)
    case.run("fsiPisoFoam")
    return case.path


def slide(case, kind):
    """Top and bottom along which the fluid slides."""
    def edit(name, old, new):
        path = os.path.join(case, name)
        text = results.read(path).replace(old, new)
        with open(path, "w", encoding="ascii") as stream:
            stream.write(text)

    if kind != "slip":
        edit("constant/polyMesh/boundary", "wall;", kind + ";")
        edit("constant/polyMesh/boundary", "(wall)", f"({kind})")
        for side in ("top", "bottom"):
            edit("0/p", f"{side} {{ type zeroGradient;",
                 f"{side} {{ type {kind};")
    for side in ("top", "bottom"):
        edit("0/U", f"{side} {{ type fixedValue; value uniform (1 0 0);",
             f"{side} {{ type {kind};")


def velocities(case, time):
    """Velocities along x of all cells."""
    text = results.read(case, time, "U")
    return results.numbers(text, "internalField")[::3]


def check_uniform(report, folder):
    """Nothing changes."""
    for name, (inlet, outlet) in CONDITIONS.items():
        case = report.attempt(name, solve, folder, name, inlet, outlet)
        if case is None:
            continue
        worst = max(abs(u - 1) for u in velocities(case, "0.1"))
        report.check(f"{name}: the flow stays uniform", worst < 1e-6, worst)


def check_total_pressure(report, folder):
    """p + U^2/2 = 1/2 at the inlet, p = 0 at the outlet: from rest the fluid
    speeds up as du/dt = (1 - u^2)/(2 L)."""
    name = "totalPressure"
    case = report.attempt(
        name, solve, folder, name,
        ("type pressureInletOutletVelocity; value uniform (0 0 0);",
         "type totalPressure; p0 uniform 0.5; value uniform 0;"),
        None, velocity="(0 0 0)", speed=0)
    if case is None:
        return
    expected = math.tanh(0.1/(2*LENGTH))
    # Walls that slide with the speed 1 drag what is near them
    middle = sorted(velocities(case, "0.1"))[24*48//2 - 1]
    report.check("totalPressure: the fluid speeds up as it must",
                 abs(middle/expected - 1) < 0.03, f"{middle} {expected}")


POST = """
disc { shape { type circle; radius 0.15; } material { density 1; E 100; } }
post { shape { type circle; radius 0.3; } material { type rigid; density 1; }
    motion { type fixed; } }
"""
PLACES = """
discs { type listed; shape disc; velocity (1 0 0);
    objects ({ centre (0.5 0.6 0); }); }
posts { type listed; shape post; objects ({ centre (1.2 -0.1 0); }); }
"""


def check_obstacle(report, folder):
    """A fixed post that reaches beyond the domain is neither in the fraction
    of the area nor in the objects' mean velocity."""
    case = report.attempt("obstacle", channel, folder, "obstacle", (),
                          shapes=POST, placements=PLACES, endTime=0.03,
                          writeInterval=3)
    if case is None or not report.attempt("obstacle, run", case.run,
                                          "fsiPisoFoam"):
        return
    lines = results.read(case.path, "log.seedObjects").split("\n")
    post, = (line for line in lines if line.startswith("    post:"))
    total, = (line for line in lines if line.startswith("    all:"))
    part = float(total.split("fraction ")[1].split()[0])
    report.check("the fraction of the area is that of the free objects",
                 "fraction" not in post
                 and abs(part/(math.pi*0.15**2/2) - 1) < 0.02, f"{post} {part}")
    mean = results.table(case.path, "global.csv")[-1]["objectVelocityX"]
    own = results.table(case.path, "objects.csv")[-2]["velocityX"]
    report.check("the objects' mean velocity is that of the free ones",
                 abs(mean/own - 1) < 1e-9, f"{mean} {own}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_uniform(report, folder)
    check_total_pressure(report, folder)
    check_obstacle(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
