# SPDX-License-Identifier: GPL-3.0-or-later
"""Films between two discs that move in a given way, in a closed box of ten
radii in Stokes flow: forces and torques over the exact ones, in the mean over
random places and directions.

The discs approach each other (squeeze), pass each other (slide), turn against
each other as two rolls (roll), or one turns beside the other (turn).

resistances.csv has the exact values: forces per length over mu V, torques over
mu V R, where each disc moves with V or turns with V/R. They are the
coefficients of a biharmonic stream function (Laurent series of Goursat's
functions about both discs, with a polynomial for the box) that meets the
velocities on discs and box in the sense of least squares, to 1e-5. They are
means over the directions 0, 22.5 and 45 degrees, from which each differs by
1 to 3 % in gaps up to a quarter of a radius.
"""

import csv
import math
import os
import random

from common import Case, Row, body

VISCOSITY = 1e6

# Gaps and time steps over h and h^2/nu; the largest step first
GAPS = (3, 2, 1.5, 1, 0.7, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05)
STEPS = (10, 1, 0.25)

# Of each motion: the velocities of both discs along and across the line of
# centres, and how fast they turn
MOTIONS = {
    "squeeze": ((1, 0, 0), (-1, 0, 0)),
    "slide": ((0, 1, 0), (0, -1, 0)),
    "roll": ((0, 0, 1), (0, 0, -1)),
    "turn": ((0, 0, 1), (0, 0, 0)),
}

# Rows of each motion: column of the table, disc, component
ROWS = {
    "squeeze": (("squeezeForce", 1, 0),),
    "slide": (("slideForce", 0, 1), ("slideTorque", 0, 2)),
    "roll": (("rollForce", 1, 1), ("rollTorque", 0, 2)),
    "turn": (("turnForce", 1, 1), ("turnTorque", 0, 2)),
}


def exact():
    """Rows of the table by their gap in radii."""
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "resistances.csv")
    with open(path, encoding="ascii") as stream:
        return {round(float(row["gap"]), 6):
                {key: float(value) for key, value in row.items()}
                for row in csv.DictReader(stream)}


def motion(velocity, along, radius):
    """Entry of a disc that moves."""
    n, t, turn = velocity
    if turn:
        return ("motion { type rotating; angularVelocity "
                f"(0 0 {turn/radius}); }}")
    x = n*along[0] - t*along[1]
    y = n*along[1] + t*along[0]
    if x == 0 and y == 0:
        return "motion { type fixed; }"
    return f"motion {{ type translating; velocity ({x!r} {y!r} 0); }}"


def forces(name, gap, step, radius, place):
    """Of each disc: force along and across the line of centres over mu V,
    torque over mu V R; and minutes. Lengths are cells."""
    side = 10*radius
    along = (math.cos(place[2]), math.sin(place[2]))
    shapes = placements = ""
    for i, sign in enumerate((-1, 1)):
        away = sign*(radius + gap/2)
        centre = [side/2 + place[k] + away*along[k] for k in range(2)]
        shapes += body(f"disc{i}", f"circle; radius {radius};",
                       "type rigid; density 1;",
                       motion(MOTIONS[name][i], along, radius))
        placements += (f"p{i} {{ type listed; shape disc{i}; objects "
                       f"({{ centre ({centre[0]!r} {centre[1]!r} 0); }}); }}\n")
    case = Case(
        f"resistances-{name}", box=(0, 0, side, side), cells=(side, side),
        viscosity=VISCOSITY, shapes=shapes, placements=placements,
        properties="contact { law { type none; } } "
                   "output { objectsEvery 1; }",
        deltaT=step/VISCOSITY, endTime=9*radius**2/VISCOSITY,
        timePrecision=12, writeInterval=1)
    minutes = case.solve()
    result = []
    for row in case.objects()[-2:]:
        x, y = row["forceX"], row["forceY"]
        result.append([value/VISCOSITY for value in (
            x*along[0] + y*along[1], y*along[0] - x*along[1],
            row["torqueZ"]/radius)])
    return result, minutes


def resistances(cells=(8, 16), steps=STEPS, gaps=GAPS, n=10):
    """Mean of the absolute values over the exact ones, and the largest; of a
    sliding film also the force along the line of centres, which should be 0,
    over the exact one across."""
    table = exact()
    generator = random.Random(1)
    places = [(generator.random(), generator.random(),
               2*math.pi*generator.random()) for i in range(n)]
    for width, step, gap in ((w, s, g) for w in cells for s in steps
                             for g in gaps):
        radius = width//2
        known = table[round(gap/radius, 6)]
        for name in MOTIONS:
            runs = [forces(name, gap, step, radius, p) for p in places]
            minutes = sum(run[1] for run in runs)
            wanted = [(column, disc, cmpt, known[column], 1)
                      for column, disc, cmpt in ROWS[name]]
            if name == "slide":
                wanted.append(("slide, force along", 0, 0,
                               known["slideForce"], 0))
            for what, disc, cmpt, value, should in wanted:
                ratios = [abs(run[0][disc][cmpt])/value for run in runs]
                yield Row(f"{what}, gap {gap} h, largest {max(ratios):.2f}",
                          f"D/h = {width}, step {step}", should,
                          sum(ratios)/n, None, minutes)


LONG = {"resistances": resistances}
