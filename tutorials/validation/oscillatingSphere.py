# SPDX-License-Identifier: GPL-3.0-or-later
"""A neo-Hookean sphere in a cyclic box of four radii, at rest and drawn by 10 %
at first, swings and comes to rest.

Radius, density and shear modulus are 1, the volume term's bulk modulus 20, the
viscosity 0.05. There is no reference: energies must never rise, the volume
stays, and the order is that of differences from mesh to mesh. Steps are the
same on all meshes.
"""

import results
from common import Case, Row, placed, sphere
from energy import energies, largest_rise, orders

# E for G = 1, K = 20: 9 K G/(3 K + G)
MATERIAL = f"type neoHookean; density 1; E {180/61!r}; areaStiffness 40;"

RATIO = 1.5


def swing(cells, end=6, step=0.02):
    """Elastic sphere with radius/h = cells."""
    case = Case(
        f"oscillating-{cells}", box=(-2,)*3 + (2,)*3, cells=(4*cells,)*3,
        viscosity=0.05, cyclic="xyz", shapes=sphere(1, MATERIAL),
        placements=placed("sphere", (0.013, -0.017, 0.011)),
        properties="output { objectsEvery 1; }",
        p_tolerance=1e-9, U_tolerance=1e-9,
        deltaT=step, endTime=end, writeInterval=end/20).set_up()
    case.stretch("sphere", 1.1, 1.1**-0.5, 1.1**-0.5)
    return case


def what_is_kept(case, minutes):
    """Rows of one run: energy and volume."""
    what = "elastic sphere that swings, "
    grid = f"a/h = {case.values['cells'][0]//4}"
    steps = results.table(case.path, "global.csv")
    yield largest_rise(what, grid, [sum(pair) for pair in energies(case)],
                       minutes)
    yield Row(f"{what}largest change of the volume over it", grid, 0,
              max(row["areaChange"] for row in steps), 1e-6, minutes)


def oscillating():
    """Three meshes."""
    ladder = []
    for cells in (4, 6, 9):
        case = swing(cells)
        minutes = case.solve_only()
        ladder.append(energies(case))
        yield from what_is_kept(case, minutes)
    yield from orders("elastic sphere that swings, ", "a/h = 4, 6, 9", ladder,
                      RATIO, minutes, "t = 6")


CASES = {"oscillatingSphere": oscillating}
