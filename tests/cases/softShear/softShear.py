#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The volume term of a soft body is no viscosity (doc/theory.md, (5.19)).

    softShear.py FOLDER

A neo-Hookean disc in the shear flow between two walls, its volume term 40 times
as stiff as its shear. It takes a steady shape in which its inside goes round.
Taylor's deformation D of that shape with a step of 0.06 h/(radius times shear
rate) is within 4 % of that with a quarter of the step. The stiffness that the
response has against all strains made D 17 % smaller.

Units: radius, shear rate and the fluid's density are 1.
"""

import os
import sys

import fsiCase
import results

CELLS, HALF = 4, 4
VISCOSITY, CAPILLARY = 20, 0.2
STEP = 0.06/CELLS


def deformation(folder, step):
    """Taylor's deformation at the time 4 and the one at 3."""
    shear = VISCOSITY/CAPILLARY
    kappa = 40*shear
    E = 4*(kappa/2)*shear/(kappa/2 + shear)
    n = 2*HALF*CELLS
    case = fsiCase.Case(
        os.path.join(folder, f"step{step}"), box=(-HALF, -HALF, HALF, HALF),
        cells=(n, n), viscosity=VISCOSITY, cyclic="x",
        walls={"top": f"({HALF} 0 0)", "bottom": f"({-HALF} 0 0)"},
        shapes="disc { shape { type circle; radius 1; } material { "
               f"type neoHookean; density 1; E {E}; areaStiffness {kappa}; }} "
               "}",
        placements="all { type listed; shape disc; "
                   "objects ({ centre (0 0 0); }); }",
        properties="output { objectsEvery 1; }", deltaT=step, endTime=4)
    case.set_up()
    case.run("fsiPisoFoam")
    rows = results.table(case.path, "objects.csv")
    return [row["deformation"] for row in rows]


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    large, small = (deformation(folder, step) for step in (STEP, STEP/4))
    print(f"    D = {large[-1]:.4f}, with a quarter of it {small[-1]:.4f}")
    report.check("the deformation does not depend on the step",
                 abs(large[-1]/small[-1] - 1) < 0.04,
                 f"{large[-1]}, not {small[-1]}")
    before = small[3*len(small)//4]
    report.check("the shape is steady", abs(small[-1]/before - 1) < 0.01,
                 f"{before}, then {small[-1]}")


if __name__ == "__main__":
    main(sys.argv[1])
