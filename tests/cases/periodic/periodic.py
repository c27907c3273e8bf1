#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What crosses a cyclic patch moves as what does not.

    periodic.py FOLDER

In a domain that is periodic in both directions nothing changes when all is
moved by whole cells: two discs that collide in the middle, across one seam and
across both; a disc in prescribed motion. Then the driving force.
"""

import math
import os
import re
import sys

import fsiCase
import results

# Of the box's side
TOLERANCE = 1e-10

# Whole cells of 48
SHIFTS = {"one seam": (0.5, 0), "both seams": (0.5, 21/48)}

DISC = """
disc
{{
    shape {{ type circle; radius 0.1; }}
    material {{ density {}; E 100; }}
    motion {{ {} }}
}}
"""

# Centre and velocity of two discs that collide in a stream (1, 1)
COLLIDING = ((0.3, 0.4, 2, 1), (0.6, 0.43, 0, 1))

STREAM = "(1 1 0)"


def box(folder, name, discs, shift=(0, 0), density=1.5, motion="",
        **parameters):
    """A periodic square with discs that are moved by the shift, seeded."""
    objects = " ".join(
        f"{{ centre ({(x + shift[0]) % 1} {(y + shift[1]) % 1} 0); "
        f"velocity ({u} {v} 0); }}" for x, y, u, v in discs)
    options = {
        "cells": (48, 48), "cyclic": "xy", "viscosity": 0.01,
        "shapes": DISC.format(density, motion),
        "placements":
            f"discs {{ type listed; shape disc; objects ({objects}); }}",
        "deltaT": 0.005, "endTime": 0.3, "writeInterval": 60,
        "writePrecision": 17, "p_tolerance": 1e-13, "U_tolerance": 1e-13,
        "U_controls": "responseTolerance 1e-13; responseMaxIter 200;",
        **parameters,
    }
    return fsiCase.Case(os.path.join(folder, name.replace(" ", "-")),
                        **options).set_up()


def solve(*args, ranks=None, **parameters):
    """Makes and runs a box, on (nx, ny) ranks; the case folder."""
    case = box(*args, **parameters)
    if ranks is None:
        case.run("fsiPisoFoam")
        return case.path
    case.run("fsiPisoFoam", ranks=case.decompose(*ranks))
    return case.path


def difference(one, other, shift, rank=""):
    """Largest distance of nodes at the end, less the shift and periods."""
    time = "0.3"
    a, b = results.outlines(one, time), results.outlines(other, time, rank)
    largest = 0
    for i in a:
        for p, q in zip(a[i], b[i]):
            d = [q[k] - p[k] - shift[k] for k in (0, 1)]
            largest = max(largest, math.hypot(*(x - round(x) for x in d)))
    return largest


def check_collision(report, folder):
    """Two discs that collide."""
    middle = report.attempt("collision in the middle", solve, folder, "middle",
                            COLLIDING, velocity=STREAM)
    if middle is None:
        return
    rows = results.table(middle, "global.csv")
    gap = min(r["smallestGap"] for r in rows)
    # Contact acts below 3 h
    report.check("the discs collide", gap < 2.5/48, f"gap {gap:.3f}")

    for name, shift in SHIFTS.items():
        case = report.attempt(f"collision across {name}", solve, folder, name,
                              COLLIDING, shift, velocity=STREAM)
        if case is None:
            continue
        error = difference(middle, case, shift)
        print(f"    across {name}: nodes differ by {error:.2e}")
        report.check(f"the same across {name}", error <= TOLERANCE,
                     f"nodes differ by {error:.2e}")
        centres = [results.centroid(polygon)
                   for polygon in results.outlines(case, "0.3").values()]
        report.check(f"centres are in the domain, {name}",
                     all(0 <= x <= 1 for c in centres for x in c), centres)
        ends = [results.table(c, "objects.csv")[-2:] for c in (middle, case)]
        apart = max(abs(b["unwrapped" + d] - a["unwrapped" + d]
                        - (start[k] + shift[k]) % 1 + start[k])
                    for a, b, start in zip(*ends, COLLIDING)
                    for k, d in enumerate("XY"))
        report.check(f"unwrapped places do not jump, {name}",
                     apart <= TOLERANCE, f"{apart:.2e} apart")
        state = results.read(case, "0.3/uniform/fsiObjects/disc")
        report.check(f"crossings are counted, {name}",
                     any(results.numbers(state, "periods")),
                     "no periods of the discs")

    shift = SHIFTS["both seams"]
    for ranks in ((2, 1), (1, 2)):
        name = f"{ranks[0]} by {ranks[1]} ranks"
        case = report.attempt(name, solve, folder, name, COLLIDING, shift,
                              ranks=ranks, velocity=STREAM)
        if case:
            error = difference(middle, case, shift, "processor0")
            print(f"    {name}: nodes differ by {error:.2e}")
            report.check(f"{name} give the same", error <= 1e-9,
                         f"nodes differ by {error:.2e}")


def check_prescribed(report, folder):
    """The force on a disc in prescribed motion."""
    forces = []
    for name, x in (("inside", 0.2), ("across", 0.2 + 28/48)):
        case = report.attempt(
            f"prescribed motion {name}", solve, folder, name,
            ((x, 0.5, 0, 0),), motion="type translating; velocity (1 0 0);",
            writeInterval=10)
        if case is None:
            return
        forces.append([r["forceX"]
                       for r in results.table(case, "objects.csv")])
    error = max(abs(a - b) for a, b in zip(*forces))/max(map(abs, forces[0]))
    print(f"    forces {forces[0][-1]:.4f} at the end, differ by {error:.2e}")
    report.check("prescribed motion: the same force across the seam",
                 error <= 1e-8, f"differs by {error:.2e}")


def check_driving(report, folder):
    """Fluid and objects as heavy as it are driven alike."""
    case = report.attempt(
        "constant acceleration", solve, folder, "acceleration",
        ((0.5, 0.5, 0, 0),), density=1,
        properties="drivingForce { type acceleration; "
                   "acceleration (2 0 0); }\n")
    if case:
        # To first order in the time step: cells inside objects have the
        # velocity of the start of the step while the fluid's is solved
        v = results.table(case, "objects.csv")[-1]["velocityX"]
        report.check("an object as heavy as the fluid is driven like it",
                     abs(v - 0.6) < 0.005*0.6, f"velocity {v}, not 0.6")

    case = report.attempt(
        "mean velocity", solve, folder, "meanVelocity", ((0.5, 0.5, 0, 0),),
        cyclic="x", density=1.2,
        properties="drivingForce { type meanVelocity; velocity (0.5 0 0); "
                   "relaxationTime 0.02; }\noutput { log full; }\n")
    if case:
        means = [float(m) for m in re.findall(
            r"Mean velocity (\S+),", results.read(case, "log.fsiPisoFoam"))]
        report.check("the mean velocity is kept", abs(means[-1] - 0.5) < 2e-4,
                     f"{means[-1]}, not 0.5")


def check_refusal(report, folder):
    """A period that is too short for an object."""
    case = report.attempt(
        "short period, set-up", box, folder, "short", ((0.5, 0.5, 0, 0),),
        shapes="disc { shape { type circle; radius 0.46; } "
               "nodeSpacing 0.05; material { density 1; E 100; } }",
        placements="discs { type listed; shape disc; wallGap 0; "
                   "objects ({ centre (0.5 0.5 0); }); }")
    if case is None:
        return
    try:
        case.run("fsiPisoFoam")
        message = "accepted"
    except RuntimeError as error:
        message = str(error)
    report.check("a period too short for an object is refused",
                 "does not fit into the period" in message, message)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_collision(report, folder)
    check_prescribed(report, folder)
    check_driving(report, folder)
    check_refusal(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
