#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc in a lid-driven cavity, 50 steps with the default coupling, for many
densities, stiffnesses and time steps.

    sweep.py FOLDER

Units: side and lid speed 1, fluid density 1. The time step is that of the
Courant number, the viscosity that of D = dt nu/h^2. Bounds: the lid is the
only source of motion, so the mean-square speed of the disc's nodes stays below
the lid's at every step; the area within 0.1 %.
"""

import itertools
import os
import sys

import fsiCase
import results

CELLS = 32
STEPS = 50
RADIUS = 0.15
LID_SPEED = 1
RATIOS = (0.5, 1, 1.1, 2, 10)
STIFFNESS = (10, 1e6)
DIFFUSION = (0.05, 1, 50)
AREA_CHANGE = 1e-3

#      density ratio, E, D, Courant number
RUNS = ([(*r, 1) for r in itertools.product(RATIOS, STIFFNESS, DIFFUSION)]
        + [(*r, 0.1) for r in itertools.product((0.5, 1), STIFFNESS,
                                                 DIFFUSION)])


# The coupling of the thesis on one of the runs, to show that the bounds tell
UNSTABLE = (0.5, 1e6, 1, 1)


def solve(folder, ratio, stiffness, diffusion, courant, coupling=""):
    """Runs one case; the rows of global.csv and the CPU time."""
    h = 1/CELLS
    dt = courant*h/LID_SPEED
    case = fsiCase.Case(
        os.path.join(folder, "case"),
        cells=(CELLS, CELLS), viscosity=diffusion*h*h/dt,
        walls={"top": f"({LID_SPEED} 0 0)"},
        properties=coupling,
        shapes=f"disc {{ shape {{ type circle; radius {RADIUS}; }} material"
               f" {{ density {ratio}; E {stiffness}; }} }}",
        placements="one { type listed; shape disc; objects ("
                   "{ centre (0.5 0.7 0); }); }",
        deltaT=dt, endTime=STEPS*dt, writeInterval=STEPS, timePrecision=12,
    ).set_up()
    case.run("fsiPisoFoam", limit=600)
    # The disc's thickness is the mesh's
    polygon = results.outlines(case.path, "0")[0]
    mass = ratio*results.area(polygon)*h
    return results.table(case.path, "global.csv"), mass, case.seconds


def speed(row, mass):
    """Root of the mean-square speed of the nodes."""
    return (2*row["kineticEnergy"]/mass)**0.5


def bounded(rows, mass):
    """True if all steps are within the bounds; nan is not."""
    return (len(rows) == STEPS
            and all(speed(r, mass) <= LID_SPEED for r in rows)
            and all(r["areaChange"] <= AREA_CHANGE for r in rows))


def main(folder):
    """The checks, and the table."""
    report = fsiCase.Report()
    total = 0
    print(f"    {'ratio':>6} {'E':>8} {'dt nu/h2':>9} {'CFL':>5} {'steps':>6} "
          f"{'speed, largest':>15} {'at end':>8} {'area change':>12}")
    for run in RUNS:
        name = "ratio {}, E {:g}, dt nu/h2 {:g}, CFL {:g}".format(*run)
        try:
            rows, mass, seconds = solve(folder, *run)
        except Exception as error:  # the others must run
            report.check(name, False, str(error))
            continue
        total += seconds["fsiPisoFoam"]
        speeds = [speed(r, mass) for r in rows]
        area = max(r["areaChange"] for r in rows)
        print("    {:6g} {:8g} {:9g} {:5g} ".format(*run)
              + f"{len(rows):6d} {max(speeds):15.4f} {speeds[-1]:8.4f} "
                f"{area:12.1e}")
        report.check(
            name, bounded(rows, mass),
            f"{len(rows)} steps, speed up to {max(speeds):.3g}, area change "
            f"{area:.1e}",
        )
    print(f"    CPU time {total:.0f} s")

    try:
        rows, mass, _ = solve(folder, *UNSTABLE, "coupling { type weak; }\n")
        stable = bounded(rows, mass)
    except RuntimeError:
        stable = False
    report.check("weak coupling is seen to be unstable", not stable,
                 "it stays within the bounds")


if __name__ == "__main__":
    main(sys.argv[1])
