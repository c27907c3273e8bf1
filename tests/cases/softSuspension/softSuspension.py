#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs on 30 % of a driven channel, so soft that it draws them out to several
times their diameter: rho nu 6 U/H over the modulus is 0.6. No node may be fired
off: speeds below three times the mean flow's, the bound of the scenarios.

    softSuspension.py FOLDER

Units: height of the channel, mean speed and density 1.
"""

import os
import sys

import fsiCase
import results

CELLS = 40
STEP = 0.005
LIMIT = 3

# Material beside the density and E = 10, end
CASES = {
    "elastic": ("", 1),
    "neo-Hookean, as viscous as the fluid":
        ("type neoHookean; viscosity 1;", 2),
    "neo-Hookean, a fifth as viscous":
        ("type neoHookean; viscosity 0.2;", 2),
}


def channel(path, material, end):
    """The case."""
    return fsiCase.Case(
        path, box=(0, 0, 2, 1), cells=(2*CELLS, CELLS), viscosity=1,
        density=1, cyclic="x",
        shapes="disc { shape { type circle; radius 0.1; } "
               f"material {{ density 1; E 10; {material} }} }}",
        placements="all { type packed; shape disc; areaFraction 0.3; "
                   "wallGap 0.04; minimumGap 0.04; }",
        properties="drivingForce { type meanVelocity; velocity (1 0 0); }",
        deltaT=STEP, endTime=end, writeInterval=end)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for i, (name, (material, end)) in enumerate(CASES.items()):
        case = channel(os.path.join(folder, str(i)), material, end)
        if not (report.attempt(name, case.set_up)
                and report.attempt(name, case.run, "fsiPisoFoam")):
            continue
        rows = results.table(case.path, "global.csv")
        fastest = max(row["maxSpeed"] for row in rows)
        print(f"    {name}: largest speed {fastest:.3g}")
        report.check(f"{name}: to the end", rows[-1]["time"] > end - STEP/2)
        report.check(f"{name}: no node is fired off", fastest < LIMIT,
                     f"speed {fastest:.3g}")


if __name__ == "__main__":
    main(sys.argv[1])
