# SPDX-License-Identifier: GPL-3.0-or-later
"""Films between two discs or two spheres that move in a given way, in a closed
box of ten radii in Stokes flow: forces and torques over the exact ones, in the
mean over random places and directions.

The bodies approach each other (squeeze), pass each other (slide), turn against
each other as two rolls (roll), or one turns beside the other (turn).

resistances.csv and resistances3D.csv have the exact values. Two dimensions:
forces per length over mu V, torques over mu V R, where each disc moves with V
or turns with V/R. They are the coefficients of a biharmonic stream function
(Laurent series of Goursat's functions about both discs, with a polynomial for
the box) that meets the velocities on discs and box in the sense of least
squares, to 1e-5. They are means over the directions 0, 22.5 and 45 degrees,
from which each differs by 1 to 3 % in gaps up to a quarter of a radius.

Three dimensions: forces over mu V R, torques over mu V R^2, without the box.
Squeeze is Brenner's series, see lubrication.py; the others are the coefficients
of Lamb's solution about both spheres, up to the degree 140, that meets the
velocities in the sense of least squares, to 2e-5. Spheres that roll have both a
force to the same side, which the box doubles; it is left out. The box adds up
to 8 % to the other forces.

Tolerances: squeeze 10 % in gaps from 4 to 0.3 h and 20 % down to 0.1 h, slide
and roll 15 %, the force that should be 0 10 %.
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

# Of each motion: the velocities of both bodies along and across the line of
# centres, and how fast they turn
MOTIONS = {
    "squeeze": ((1, 0, 0), (-1, 0, 0)),
    "slide": ((0, 1, 0), (0, -1, 0)),
    "roll": ((0, 0, 1), (0, 0, -1)),
    "turn": ((0, 0, 1), (0, 0, 0)),
}

# Rows of each motion: column of the table, body, component
ROWS = {
    "squeeze": (("squeezeForce", 1, 0),),
    "slide": (("slideForce", 0, 1), ("slideTorque", 0, 2)),
    "roll": (("rollForce", 1, 1), ("rollTorque", 0, 2)),
    "turn": (("turnForce", 1, 1), ("turnTorque", 0, 2)),
}


# Down to a gap of 0.1 h
TOLERANCES = {"squeeze": 0.1, "slide": 0.15, "roll": 0.15}


def exact(n_dims=2):
    """Rows of the table by their gap in radii."""
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        f"resistances{'3D' if n_dims == 3 else ''}.csv")
    with open(path, encoding="ascii") as stream:
        return {round(float(row["gap"]), 6):
                {key: float(value) for key, value in row.items()}
                for row in csv.DictReader(stream)}


def dot(a, b):
    """Scalar product."""
    return sum(x*y for x, y in zip(a, b))


def unit(a):
    """A vector of length 1."""
    return [x/math.sqrt(dot(a, a)) for x in a]


def random_place(generator, n_dims):
    """Offset of the middle in cells, and three unit vectors: along the line of
    centres, across it, and the axis about which bodies turn."""
    offset = [generator.random() for i in range(n_dims)]
    if n_dims == 2:
        angle = 2*math.pi*generator.random()
        along = [math.cos(angle), math.sin(angle), 0]
        return offset, along, [-along[1], along[0], 0], [0, 0, 1]
    along, other = (unit([generator.gauss(0, 1) for i in range(3)])
                    for j in range(2))
    across = unit([y - dot(other, along)*x for x, y in zip(along, other)])
    return offset, along, across, [
        along[i - 2]*across[i - 1] - along[i - 1]*across[i - 2]
        for i in range(3)]


def motion(velocity, radius, place):
    """Entry of a body that moves."""
    n, t, turn = velocity
    _, along, across, axis = place
    if turn:
        return ("motion {{ type rotating; angularVelocity ({!r} {!r} {!r}); }}"
                .format(*(turn/radius*x for x in axis)))
    if not n and not t:
        return "motion { type fixed; }"
    return "motion {{ type translating; velocity ({!r} {!r} {!r}); }}".format(
        *(n*x + t*y for x, y in zip(along, across)))


def forces(name, gap, step, radius, place, n_dims=2):
    """Of each body: force along and across the line of centres over mu V, of
    spheres over mu V R, torque over R as much; and minutes. Lengths are
    cells."""
    side = 10*radius
    offset, along, across, axis = place
    form = "circle" if n_dims == 2 else "sphere"
    shapes = placements = ""
    for i, sign in enumerate((-1, 1)):
        away = sign*(radius + gap/2)
        centre = " ".join([repr(side/2 + x + away*y)
                           for x, y in zip(offset, along)] + ["0"][n_dims - 2:])
        shapes += body(f"b{i}", f"{form}; radius {radius};",
                       "type rigid; density 1;",
                       motion(MOTIONS[name][i], radius, place))
        placements += (f"p{i} {{ type listed; shape b{i}; objects "
                       f"({{ centre ({centre}); }}); }}\n")
    case = Case(
        f"resistances-{n_dims}D-{name}", box=(0,)*n_dims + (side,)*n_dims,
        cells=(side,)*n_dims, viscosity=VISCOSITY, shapes=shapes,
        placements=placements,
        properties="contact { law { type none; } } "
                   "output { objectsEvery 1; }",
        deltaT=step/VISCOSITY, endTime=9*radius**2/VISCOSITY,
        timePrecision=12, writeInterval=1)
    minutes = case.solve()
    size = VISCOSITY*radius**(n_dims - 2)
    result = []
    for row in case.objects()[-2:]:
        force, torque = ([row.get(key + cmpt, 0)/size for cmpt in "XYZ"]
                         for key in ("force", "torque"))
        result.append([dot(force, along), dot(force, across),
                       dot(torque, axis)/radius])
    return result, minutes


def resistances(n_dims=2, cells=(8, 16), steps=STEPS, gaps=GAPS, n=10):
    """Mean of the absolute values over the exact ones, and the largest; of a
    sliding film also the force along the line of centres, which should be 0,
    over the exact one across."""
    table = exact(n_dims)
    generator = random.Random(1)
    places = [random_place(generator, n_dims) for i in range(n)]
    for width, step, gap in ((w, s, g) for w in cells for s in steps
                             for g in gaps):
        radius = width//2
        known = table[round(gap/radius, 6)]
        for name in MOTIONS:
            runs = [forces(name, gap, step, radius, p, n_dims) for p in places]
            minutes = sum(run[1] for run in runs)
            wanted = [(column, which, cmpt, known[column], 1)
                      for column, which, cmpt in ROWS[name]
                      if (n_dims, column) != (3, "rollForce")]
            if name == "slide":
                wanted.append(("slide, force along", 0, 0,
                               known["slideForce"], 0))
            for what, which, cmpt, value, should in wanted:
                ratios = [abs(run[0][which][cmpt])/value for run in runs]
                tolerance = 0.1 if should == 0 else TOLERANCES.get(name)
                if gap < 0.1:
                    tolerance = None
                elif name == "squeeze" and gap < 0.3:
                    tolerance = 0.2
                yield Row(f"{n_dims}D {what}, gap {gap} h, from "
                          f"{min(ratios):.2f} to {max(ratios):.2f}",
                          f"D/h = {width}, step {step}", should,
                          sum(ratios)/n, tolerance, minutes)


def few():
    """Two dimensions, what takes minutes."""
    return resistances(2, (8,), STEPS[:2], GAPS, 4)


def spheres():
    """Three dimensions."""
    yield from resistances(3, (8,), (10,),
                           (3, 2, 1, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05), 3)
    yield from resistances(3, (8,), (1,), (1, 0.5, 0.2, 0.1), 2)


def all_spheres():
    """Three dimensions, hours."""
    yield from resistances(3, (8,), (10,),
                           (3, 2, 1, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05), 10)
    yield from resistances(3, (16,), (10,), (2, 1, 0.5, 0.3, 0.1), 3)


LONG = {"resistances": resistances, "fewResistances": few,
        "sphereResistances": spheres, "allSphereResistances": all_spheres}
