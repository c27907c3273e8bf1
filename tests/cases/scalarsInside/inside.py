#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scalars inside bodies, with a partition coefficient and a diffusivity of
their own.

    inside.py FOLDER

1. Bodies that move keep the amount of a scalar in fluid and bodies to
   round-off, and a uniform scalar stays uniform; in two and three dimensions,
   on one, two and three ranks, and after a restart.
2. A wall of two layers has the exact profile.
3. A disc and a sphere that make heat, in a gradient across, at rest: the exact
   solution is that of Maxwell plus that of a source. The error of the field is
   of second order, for bodies that conduct better and worse than the fluid;
   so is the error of the rate, by the volume of the body in the mesh.
4. A disc that loses its content while it moves with the fluid loses as much as
   one at rest, the nearer the finer the mesh is.
5. A restart without the volumes that cells hold gives a warning.
"""

import math
import os
import sys

import fsiCase
import results
from scalarCase import ScalarCase, ball, box, keeps
from scalarFlows import at_rest, places

BOTH = """
disc { type permeable; partition 2; diffusivity 5e-4; }
bar { type permeable; partition 0.5; diffusivity 4e-3; }
"""


def layers(report, folder):
    """Check 2: a block in a part of a channel, with values 0 and 1 on its two
    ends; the conductivity of the block is 10 times the fluid's."""
    n, edge = 20, 0.137
    case = ScalarCase(
        os.path.join(folder, "layers"),
        (("dye", "diffusivity 1; surfaces { block { type permeable; "
          "partition 4; diffusivity 2.5; } }", "uniform 0",
          {"left": "type fixedValue; value uniform 0;",
           "right": "type fixedValue; value uniform 1;"}),),
        box=(0, 0, 1, 0.5), cells=(n, n//2), viscosity=1, deltaT=10,
        endTime=200, writeInterval=20,
        shapes='block { shape { type polygon; file "block.csv"; } '
               "material { type rigid; density 1; } "
               "motion { type fixed; } }",
        placements="a { type listed; shape block; objects "
                   f"({{ centre ({(edge - 0.5)/2} 0.25 0); }}); }}")
    with open(os.path.join(case.path, "block.csv"), "w",
              encoding="ascii") as stream:
        stream.write(f"-0.5,-0.5\n{edge},-0.5\n{edge},1\n-0.5,1\n")
    case.set_up().run("fsiPisoFoam")
    flux = 1/(edge/10 + 1 - edge)
    worst = max(abs(c - (flux*x/10 if x < edge else 1 - flux*(1 - x)))
                for c, x in zip(results.field(
                    case.path, results.times(case.path)[-1], "dye"),
                    [(i % n + 0.5)/n for i in range(n*n//2)]))
    print(f"    two layers: largest error {worst:.1e}")
    report.check("two layers", worst < 1e-8, f"{worst}")


def maxwell(report, folder):
    """Check 3."""
    for solid, ladder in ((False, (8, 16, 32)), (True, (6, 12))):
        for conductivity in (10, 0.1):
            found = [at_rest(folder, n, solid, conductivity) for n in ladder]
            text = (f"{3 if solid else 2}D, conductivity {conductivity}")
            for what, errors in (
                    ("root mean square", [f.mean for f in found]),
                    ("largest error", [f.largest for f in found]),
                    ("rate", [abs(f.rate - 1) for f in found])):
                order = math.log2(errors[0]/errors[-1])/(len(ladder) - 1)
                print(f"    {text}: {what} "
                      + ", ".join(f"{e:.5f}" for e in errors)
                      + f", order {order:.2f}")
                report.check(f"{text}: order of {what}",
                             order > (1.25 if what[0] == "l" else 1.7),
                             f"{errors}")


def lost(folder, n, speed):
    """Part of its content that a disc has at the end, with n cells to the
    diameter."""
    half, radius = 1, 0.25
    cells = round(half/radius*n)
    axis = places(cells, half)
    start = " ".join("1" if math.hypot(x, y) < radius else "0"
                     for y in axis for x in axis)
    body = ball(False)
    if speed:
        body["shapes"] = body["shapes"].replace(
            "type fixed;", f"type translating; velocity ({speed} 0 0);")
    case = ScalarCase(
        os.path.join(folder, f"lost{n}v{speed}"),
        (("dye", "diffusivity 0.01; surfaces { disc { type permeable; "
          "partition 3; diffusivity 0.02; } }",
          f"nonuniform List<scalar> {cells**2} ({start})", {}),),
        box=(-half, -half, half, half), cells=(cells, cells), viscosity=0.1,
        velocity=f"({speed} 0 0)", cyclic="xy", deltaT=0.08/n**2, endTime=0.4,
        writeInterval=5*n*n, **body).set_up()
    case.run("fsiPisoFoam")
    rows = results.table(case.path, "dye.csv")
    return rows[-1]["indisc"]/(rows[-1]["indisc"] + rows[-1]["amount"])


def carried(report, folder):
    """Check 4."""
    gaps = []
    for n in (8, 16):
        rest, moved = (lost(folder, n, speed) for speed in (0, 1))
        print(f"    {n} cells: part that is left, at rest {rest:.4f}, "
              f"moving {moved:.4f}")
        gaps.append(abs(moved - rest))
    report.check("content goes with the body", gaps[1] < 0.01, f"{gaps}")
    report.check("order of the difference", gaps[1] < 0.6*gaps[0], f"{gaps}")


def missing(report, folder):
    """Check 5."""
    case = box(folder, "missing", endTime=0.02, writeInterval=2)
    case.run("fsiPisoFoam")
    os.remove(os.path.join(case.path, "0.02/dyeVolume"))
    case.control(endTime=0.03, startFrom="latestTime")
    case.run("fsiPisoFoam")
    report.check("a warning names the missing volumes",
                 'dyeVolume" is missing' in results.read(
                     case.path, "log.fsiPisoFoam"))


def main(folder):
    """All checks."""
    report = fsiCase.Report()
    for solid in (False, True):
        report.attempt("kept", keeps, report, folder, solid, BOTH, 0.02)
    report.attempt("layers", layers, report, folder)
    report.attempt("Maxwell", maxwell, report, folder)
    report.attempt("carried", carried, report, folder)
    report.attempt("missing", missing, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
