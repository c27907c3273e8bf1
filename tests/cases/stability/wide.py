# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten steps of a disc and of a sphere below a driven lid, for time steps of a
tenth to a hundred thousand viscous times of a cell, soft to rigid bodies and
density ratios of 0.1 to 10.

Side, lid's speed and the fluid's density are 1. The moduli of the bodies are
multiples of the flow's stress rho U^2 + mu U. No node is faster than the lid,
none of a stiff or rigid body than half of it, as the fluid there, and a stiff
body ends with the speed of a rigid one.
"""

import itertools
import os

import fsiCase
import results

STEP, STEPS = 0.01, 10
DIFFUSION = (0.1, 10, 1e3, 1e5)
RATIOS = (0.1, 10)

# Cells to a side by the number of dimensions
CELLS = {2: 16, 3: 12}

# Modulus over the flow's stress, 0: rigid; and which of them are stiff, with
# the largest difference from a rigid one's speed
MODULI, STIFF, DIFFERENCE = (0, 0.1, 10, 1e4), 1e4, 0.05


def solve(folder, cells, n_dims, ratio, stiffness, diffusion):
    """Rows of global.csv."""
    viscosity = diffusion/cells**2/STEP
    modulus = stiffness*(1 + viscosity)
    material = f"type elastic; E {modulus!r};" if stiffness else "type rigid;"
    shape, centre = (("circle", ".5 .7 0"), ("sphere", ".5 .7 .5"))[n_dims - 2]
    case = fsiCase.Case(
        os.path.join(folder, f"wide{n_dims}D"),
        box=(0,)*n_dims + (1,)*n_dims, cells=(cells,)*n_dims, density=1,
        viscosity=viscosity, walls={"top": "(1 0 0)"},
        shapes=f"a {{ shape {{ type {shape}; radius 0.2; }} "
               f"material {{ {material} density {ratio}; }} }}",
        placements="p { type listed; shape a; "
                   f"objects ({{ centre ({centre}); }}); }}",
        deltaT=STEP, endTime=STEPS*STEP).set_up()
    case.run("fsiPisoFoam")
    return results.table(case.path, "global.csv")


def check_run(report, folder, name, run):
    """Bounds of one run; returns the last speed."""
    rows = solve(folder, *run)
    most = 1 if 0 < run[3] < STIFF else 0.5
    speeds = [row["maxSpeed"] for row in rows]
    change = max(row["areaChange"] for row in rows)
    report.check(name,
                 len(rows) == STEPS and max(speeds) < most and change < 1e-3,
                 f"{len(rows)} steps, speed up to {max(speeds):.3g}, change "
                 f"of the volume {change:.2g}")
    return speeds[-1]


def check(report, folder):
    """All runs; those of rigid bodies come before those of stiff ones."""
    for n_dims, cells in CELLS.items():
        for diffusion, ratio in itertools.product(DIFFUSION, RATIOS):
            rigid = None
            for stiffness in MODULI:
                name = (f"{n_dims}D, dt nu/h2 {diffusion:g}, "
                        f"E {stiffness or 'rigid'}, ratio {ratio}")
                last = report.attempt(
                    name, check_run, report, folder, name,
                    (cells, n_dims, ratio, stiffness, diffusion))
                rigid = rigid if stiffness else last
                if stiffness == STIFF and last and rigid:
                    report.check(f"{name}: as a rigid one",
                                 abs(last/rigid - 1) < DIFFERENCE,
                                 f"{last}, not {rigid}")
