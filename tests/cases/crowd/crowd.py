#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft spheres packed to 40 % of a periodic box fly about: they start at rest
although all are within the range of contact of others, never overlap, none is
lost, and each keeps its volume, its crowd the momentum, and gains no energy.

    crowd.py FOLDER OBJECTS STEPS
"""

import math
import os
import sys

import fsiCase
import results

RADIUS = 0.5
FRACTION = 0.4

# Cells per radius, steps per radius at the spheres' speed
CELLS = 4
SPEED = 1
STEP = 0.05

SHAPES = f"""sphere {{ shape {{ type sphere; radius {RADIUS}; }}
    material {{ density 1; E 100; }} }}
"""

PLACEMENTS = """a {{ type packed; shape sphere; number {}; minimumGap 0.02;
    wallGap 0; seed 3; {} }}
"""


def crowd(folder, name, number, moving, **controls):
    """The box with its spheres, without a fluid."""
    side = (number*4/3*math.pi*RADIUS**3/FRACTION)**(1/3)
    n = round(CELLS*side/RADIUS)
    motion = (f"velocity ({SPEED} 0 0); velocityPerturbation 1;"
              if moving else "")
    return fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 0, side, side, side),
        cells=(n, n, n), cyclic="xyz", density=1, viscosity=0.01,
        deltaT=STEP*RADIUS/SPEED, writePrecision=17,
        properties="coupling { type none; }\n", shapes=SHAPES,
        placements=PLACEMENTS.format(number, motion), **controls).set_up()


def energies(row):
    """Of all kinds."""
    return row["kineticEnergy"] + row["elasticEnergy"] + row["contactEnergy"]


def check_rest(report, folder, number):
    """Nothing moves what is seeded at rest."""
    case = crowd(folder, "rest", number, False,
                 endTime=5*STEP*RADIUS/SPEED)
    case.run("fsiPisoFoam")
    rows = results.table(case.path, "global.csv")
    fastest = max(row["maxSpeed"] for row in rows)
    nearest = min(row["smallestGap"] for row in rows)
    print(f"    smallest gap {nearest/RADIUS*CELLS:.2f} h, largest speed "
          f"{fastest:.2e}")
    report.check("within the range they start at rest",
                 nearest < 3*RADIUS/CELLS and fastest < 1e-6*SPEED, fastest)


def check_crowd(report, folder, number, steps):
    """What must hold over all steps."""
    case = crowd(folder, "crowd", number, True,
                 endTime=steps*STEP*RADIUS/SPEED, writeInterval=steps//5)
    case.run("fsiPisoFoam", limit=3000)
    rows = results.table(case.path, "global.csv")
    start = energies(rows[0])
    energy = max(map(energies, rows))/start
    print(f"    {case.seconds['fsiPisoFoam']/steps:.3f} s per step, up to "
          f"{max(r['contacts'] for r in rows):.0f} contacts, smallest gap "
          f"{min(r['smallestGap'] for r in rows)/RADIUS*CELLS:.3f} h, energy "
          f"{energy:.5f} at most, {energies(rows[-1])/start:.3f} at the end, "
          f"volume {max(r['areaChange'] for r in rows):.1e}")
    report.check("the energy never grows by a thousandth", energy < 1.001,
                 energy)
    report.check("no gap closes", min(r["smallestGap"] for r in rows) > 0)
    report.check("none is lost", {r["objects"] for r in rows} == {number})
    report.check("each keeps its volume",
                 max(r["areaChange"] for r in rows) < 1e-6)
    momenta = {}
    for row in results.table(case.path, "objects.csv"):
        sums = momenta.setdefault(row["time"], [0, 0, 0])
        for k, c in enumerate("XYZ"):
            sums[k] += row["velocity" + c]/(number*SPEED)
    first = next(iter(momenta.values()))
    drift = max(math.dist(p, first) for p in momenta.values())
    print(f"    momentum changes by {drift:.1e}")
    report.check("momentum is kept", drift < 1e-10, drift)
    text = case.run("checkObjects", limit=900)
    report.check("no overlaps at written times", "Objects are sound" in text,
                 text[-500:])


def main(folder, number, steps):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("at rest", check_rest, report, folder, number)
    report.attempt("moving", check_crowd, report, folder, number, steps)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
