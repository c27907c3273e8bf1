#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc in a lid-driven cavity, 50 steps with the default coupling, for many
densities, stiffnesses and time steps; and fewer steps of more, see wide.py.

    sweep.py FOLDER          the checks of the default coupling
    sweep.py FOLDER table    a table of all couplings, 200 steps each

Units: side and lid speed 1, fluid density 1. The time step is that of the
Courant number, the viscosity that of D = dt nu/h^2. Bounds: the lid is the
only source of motion, so the mean-square speed of the disc's nodes stays below
the lid's at every step; the area within 0.1 %.
"""

import cmath
import itertools
import math
import os
import sys

import fsiCase
import results
import wide

CELLS = 32
STEPS = 50
TABLE_STEPS = 200
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


# The softest bodies are drawn out to a strain above 1 in 200 steps and must not
# crumple: E, D, Courant number
SOFTEST = (10, 50, 0.1)

# They do not with a tenth of the fluid's viscosity, nor with stiffer areas
REMEDIES = {"viscous body": "viscosity 1.56;",
            "body with stiff areas": "areaStiffness 1000;"}

# Turns that the tangent makes along the surface, there and back counted alike:
# 1 of a convex body, below 2 of one with a tip and a hollow, 2.8 to 4.4 of one
# that wrinkles from node to node
TURNS = 2


# The coupling of the thesis on one of the runs, to show that the bounds tell
UNSTABLE = (0.5, 1e6, 1, 1)


# Couplings of the table: entries of fsiProperties
COUPLINGS = {
    "`solidImplicit`, open areas": "",
    "`solidImplicit`, voxel wall": fsiCase.THESIS + "wall voxel;",
    "`weak`, `wallForce`, open areas":
        fsiCase.THESIS + "coupling { type weak; }",
    "`weak`, `nearestCell`, voxel wall":
        fsiCase.THESIS
        + "wall voxel; coupling { type weak; load nearestCell; }",
    "`weak`, `wallForce`, at most 20 Aitken sub-iterations":
        fsiCase.THESIS + "coupling { type weak; subIterations 20; }",
}


def solve(folder, ratio, stiffness, diffusion, courant, coupling="",
          steps=STEPS, material=""):
    """Runs one case; the rows of global.csv and the CPU time."""
    h = 1/CELLS
    dt = courant*h/LID_SPEED
    case = fsiCase.Case(
        os.path.join(folder, "case"),
        cells=(CELLS, CELLS), viscosity=diffusion*h*h/dt,
        walls={"top": f"({LID_SPEED} 0 0)"},
        properties=coupling,
        shapes=f"disc {{ shape {{ type circle; radius {RADIUS}; }} material"
               f" {{ density {ratio}; E {stiffness}; {material} }} }}",
        placements="one { type listed; shape disc; objects ("
                   "{ centre (0.5 0.7 0); }); }",
        deltaT=dt, endTime=steps*dt, writeInterval=steps, timePrecision=12,
    ).set_up()
    case.run("fsiPisoFoam", limit=600)
    # The disc's thickness is the mesh's
    polygon = results.outlines(case.path, "0")[0]
    mass = ratio*results.area(polygon)*h
    return results.table(case.path, "global.csv"), mass, case.seconds


def speed(row, mass):
    """Root of the mean-square speed of the nodes."""
    return (2*row["kineticEnergy"]/mass)**0.5


def bounded(rows, mass, steps=STEPS):
    """True if all steps are within the bounds; nan is not."""
    return (len(rows) == steps
            and all(speed(r, mass) <= LID_SPEED for r in rows)
            and all(r["areaChange"] <= AREA_CHANGE for r in rows))


def stable(folder, run, coupling, steps):
    """True if a run ends and stays within the bounds."""
    try:
        rows, mass, _ = solve(folder, *run, coupling, steps)
    except RuntimeError:
        return False
    return bounded(rows, mass, steps)


def turns(folder):
    """Turns of the tangent along the disc's last outline."""
    case = os.path.join(folder, "case")
    points = results.outlines(case, results.times(case)[-1])[0]
    steps = [complex(*b) - complex(*a)
             for a, b in zip(points, points[1:] + points[:1])]
    return sum(abs(cmath.phase(b/a))
               for a, b in zip(steps, steps[1:] + steps[:1]))/(2*math.pi)


def check_softest(report, folder):
    """200 steps of the softest bodies."""
    kinds = {"softest body": "", **REMEDIES}
    for (name, entry), ratio in itertools.product(kinds.items(), RATIOS):
        rows, mass, _ = solve(folder, ratio, *SOFTEST, "", TABLE_STEPS, entry)
        largest = max(speed(r, mass) for r in rows)
        name = f"{name}, ratio {ratio}"
        print(f"    {name}: speed up to {largest:.3g}, "
              f"{turns(folder):.3g} turns")
        report.check(name, bounded(rows, mass, TABLE_STEPS),
                     f"speed up to {largest:.3g}")
        report.check(f"{name}: smooth", turns(folder) < TURNS,
                     f"{turns(folder):.3g} turns")
    solve(folder, RATIOS[-1], *SOFTEST, "shortWaveStress 0;", TABLE_STEPS)
    report.check("without resistance to short waves it wrinkles",
                 turns(folder) > TURNS, f"{turns(folder):.3g} turns")


def table(folder):
    """Prints which density ratios are stable, for each coupling."""
    cases = list(itertools.product((1, 0.1), STIFFNESS, DIFFUSION))
    print("| coupling | " + " | ".join(
        f"E {e:g}, D {d:g}, Co {c:g}" for c, e, d in cases) + " |")
    print("|---" * (1 + len(cases)) + "|")
    for name, coupling in COUPLINGS.items():
        cells = []
        for courant, stiffness, diffusion in cases:
            good = [r for r in RATIOS
                    if stable(folder, (r, stiffness, diffusion, courant),
                              coupling, TABLE_STEPS)]
            cells.append("all" if len(good) == len(RATIOS) else
                         ", ".join(f"{r:g}" for r in good) or "none")
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


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

    report.attempt("wide sweep", wide.check, report, folder)
    report.attempt("softest bodies", lambda: check_softest(report, folder))
    report.check("weak coupling is seen to be unstable",
                 not stable(folder, UNSTABLE,
                            fsiCase.THESIS + "coupling { type weak; }",
                            STEPS),
                 "it stays within the bounds")


if __name__ == "__main__":
    (table if sys.argv[2:] == ["table"] else main)(sys.argv[1])
