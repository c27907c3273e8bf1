#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A light elastic body that was pushed comes to rest: in a cyclic box without a
driving force its kinetic and elastic energy can only fall.

    lightBodies.py FOLDER

A disc of 6 mesh cells at moderate stiffness, where the last pressure deforms it
as much as its inertia resists (doc/theory.md, (5.19)). Viscosity leaves less
than half of the first step's energy after 100 steps.
"""

import os
import sys

import fsiCase
import results

STEP, STEPS = 0.01, 100
LEFT = 0.5

# Name, material, further entries of the shape, viscosity of the fluid
BODIES = (
    ("a fifth of the density", "density 0.2; E 10;", "", 0.002),
    ("a tenth", "density 0.1; E 10;", "", 0.002),
    ("neo-Hookean", "type neoHookean; density 0.3; E 10;", "", 0.0005),
    ("ADMM", "density 0.5; E 10;", "admm { scheme ADMM; }", 0.002),
    ("stiff", "density 0.1; E 1e4;", "", 0.002),
    ("soft", "density 0.1; E 0.5;", "", 0.002),
)


def energies(folder, material, entries, viscosity):
    """Kinetic and elastic energy after each step."""
    case = fsiCase.Case(
        os.path.join(folder, "case"), cells=(30, 30), viscosity=viscosity,
        cyclic="xy",
        shapes="disc { shape { type circle; radius 0.1; } "
               f"material {{ {material} }} {entries} }}",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.5 0.5 0); velocity (0.3 0.1 0); }); }",
        deltaT=STEP, endTime=STEPS*STEP, writeInterval=STEPS).set_up()
    case.run("fsiPisoFoam")
    return [row["kineticEnergy"] + row["elasticEnergy"]
            for row in results.table(case.path, "global.csv")]


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for name, *body in BODIES:
        found = report.attempt(name, energies, folder, *body)
        if found is None:
            continue
        report.check(f"{name}: all steps", len(found) == STEPS,
                     f"{len(found)} steps")
        half = max(found[STEPS//2:])
        print(f"    {name}: {half/found[0]:.3g} of the first step's energy")
        report.check(f"{name}: comes to rest", 0 < half < LEFT*found[0],
                     f"{half} of {found[0]} in the second half")


if __name__ == "__main__":
    main(sys.argv[1])
