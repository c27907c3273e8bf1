#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic spheres and two rigid ones that collide in a box with a moving lid
give the same trajectories on one, two and four ranks, and when a run on one
rank goes on on two, or one on four on one.

    solidRanks.py FOLDER
"""

import os
import shutil
import sys

import fsiCase
import results

N = 24
STEPS = 100
STEP = 0.01

# Of an object's size
TOLERANCE = 1e-8

SHAPES = """sphere { shape { type sphere; radius 0.13; }
    material { density 1100; E 1e4; } }
ball { shape { type sphere; radius 0.13; }
    material { density 8000; type rigid; } }
"""

# They meet in the middle, on the seams of four ranks
PLACEMENTS = """a { type listed; shape sphere; objects
( { centre (0.24 0.5 0.5); velocity (0.5 0 0); }
  { centre (0.76 0.52 0.5); velocity (-0.5 0 0); }
  { centre (0.5 0.8 0.52); velocity (0 -0.2 0); } ); }
b { type listed; shape ball; objects
( { centre (0.5 0.24 0.48); }
  { centre (0.2 0.2 0.48); velocity (1 0 0); } ); }
"""

DECOMPOSITIONS = {2: (2, 1, 1), 4: (2, 2, 1)}


def box(folder, name):
    """The seeded box."""
    return fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 0, 1, 1, 1), cells=(N, N, N),
        density=1000, viscosity=0.01, walls={"top": "(0.5 0 0)"},
        shapes=SHAPES, placements=PLACEMENTS, startFrom="latestTime",
        properties="contact { roughness 1e-5; }",
        deltaT=STEP, endTime=STEP*STEPS, writeInterval=STEPS//2,
        writePrecision=17, p_tolerance=1e-12, U_tolerance=1e-12).set_up()


def solve(case, ranks, end=STEPS):
    """Runs a case to a step on a number of ranks and puts it together."""
    case.control(endTime=STEP*end)
    options = ("-latestTime",) if results.times(case.path)[-1] != "0" else ()
    if ranks == 1:
        case.run("fsiPisoFoam")
        return
    case.decompose(*DECOMPOSITIONS[ranks], options=options)
    case.run("fsiPisoFoam", ranks=ranks)
    case.run("reconstructPar", "-latestTime")
    for part in range(ranks):
        shutil.rmtree(os.path.join(case.path, f"processor{part}"))


def same(report, name, serial, case):
    """The end of a case is that of the serial one."""
    error = results.difference(serial.path, case.path)
    print(f"    {name}: nodes differ by {error:.2e} of an object's size")
    report.check(f"{name}: the trajectories of one rank", error <= TOLERANCE,
                 f"{error:.2e} of an object's size")


def check_serial(report, serial):
    """What the serial run must contain."""
    solve(serial, 1)
    rows = results.table(serial.path, "global.csv")
    contacts = max(row["contacts"] for row in rows)
    least = min(row["smallestGap"] for row in rows)
    print(f"    up to {contacts:.0f} contacts, smallest gap {least*N:.2f} h")
    report.check("three spheres and two balls touch", contacts >= 4, contacts)
    text = serial.run("checkObjects")
    report.check("objects are sound", "Objects are sound" in text, text[-300:])


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    serial = box(folder, "serial")
    report.attempt("one rank", check_serial, report, serial)
    for ranks in DECOMPOSITIONS:
        case = box(folder, f"ranks{ranks}")
        report.attempt(f"{ranks} ranks", solve, case, ranks)
        report.attempt(f"{ranks} ranks compared", same, report,
                       f"{ranks} ranks", serial, case)
    for first, then in ((1, 2), (4, 1)):
        name = f"from {first} to {then} ranks"
        case = box(folder, f"restart{first}{then}")
        report.attempt(name, solve, case, first, STEPS//2)
        report.attempt(name, solve, case, then)
        report.attempt(f"{name} compared", same, report, name, serial, case)


if __name__ == "__main__":
    main(sys.argv[1])
