# SPDX-License-Identifier: GPL-3.0-or-later
"""Films between a wall of the domain and a disc or a sphere that moves in a
given way, in a closed box of ten radii in Stokes flow: forces and torques over
the exact ones, in the mean over random places along the wall.

The body approaches the wall (squeeze), slides along it, or turns beside it.
Exact are, per length over mu V of a disc beside a wall without the box, with
cosh a = 1 + gap/radius (Jeffrey and Onishi, Q. J. Mech. Appl. Math. 34, 1981):
squeeze 4 pi/(a - tanh a), slide 4 pi/a without a torque, and the torque of a
disc that turns 4 pi coth(a) mu V R, without a force; of a sphere that
approaches Brenner's series, see lubrication.py. The box adds 4 to 8 mu V to the
force of sliding, which has no tolerance for that; to the others a few per cent.
"""

import math
import random

import lubrication
from common import Case, Row, body
from resistances import GAPS, TOLERANCES, VISCOSITY

# The wall is at x = 0
MOTIONS = {
    "squeeze": "translating; velocity (-1 0 0)",
    "slide": "translating; velocity (0 1 0)",
    "turn": "rotating; angularVelocity (0 0 {!r})",
}


def exact(n_dims, name, gap):
    """Force, or the torque of a disc that turns; gap over the radius."""
    a = math.acosh(1 + gap)
    if name == "squeeze":
        return lubrication.DRAGS[n_dims, 1](gap)
    return 4*math.pi/(a if name == "slide" else math.tanh(a))


def forces(n_dims, name, gap, step, radius, places):
    """Force along the normal and along the wall, and torque over the radius,
    over mu V; of a sphere over mu V R."""
    side = 10*radius
    centre = [gap + radius] + [side/2 + x for x in places] + [0]
    case = Case(
        f"wallFilms-{n_dims}D-{name}", box=(0,)*n_dims + (side,)*n_dims,
        cells=(side,)*n_dims, viscosity=VISCOSITY,
        shapes=body("b", f"{'circle' if n_dims == 2 else 'sphere'}; "
                    f"radius {radius};", "type rigid; density 1;",
                    f"motion {{ type {MOTIONS[name].format(1/radius)}; }}"),
        placements="p { type listed; shape b; wallGap 0; objects ({ centre ("
                   + " ".join(map(repr, centre[:3])) + "); }); }",
        properties="contact { law { type none; } } "
                   "output { objectsEvery 1; }",
        deltaT=step/VISCOSITY, endTime=9*radius**2/VISCOSITY,
        timePrecision=12, writeInterval=1)
    minutes = case.solve()
    row = case.objects()[-1]
    size = VISCOSITY*radius**(n_dims - 2)
    return (row["forceX"]/size, row["forceY"]/size,
            row["torqueZ"]/size/radius), minutes


def films(n_dims=2, cells=(8, 16), steps=(10, 1), gaps=GAPS, n=3):
    """Means over the places; the force on the wall, which should be 0, over the
    force of sliding."""
    generator = random.Random(1)
    places = [[generator.random() for i in range(n_dims - 1)]
              for j in range(n)]
    for width in cells:
        radius = width//2
        for step in steps:
            for gap in gaps:
                for name in list(MOTIONS)[:3 if n_dims == 2 else 1]:
                    yield from rows(n_dims, name, gap, step, radius, places)


def rows(n_dims, name, gap, step, radius, places):
    """Rows of a motion."""
    runs = [forces(n_dims, name, gap, step, radius, p) for p in places]
    minutes = sum(run[1] for run in runs)
    main = list(MOTIONS).index(name)
    wanted = [(f"{name}{'Torque' if name == 'turn' else 'Force'}", main,
               exact(n_dims, name, gap/radius), 1)]
    if name != "squeeze":
        wanted.append((f"{name}, force on the wall", 0,
                       exact(n_dims, "slide", gap/radius), 0))
    for what, cmpt, value, should in wanted:
        ratios = [abs(run[0][cmpt])/value for run in runs]
        tolerance = (0.1 if should == 0 else None if name == "slide"
                     else TOLERANCES.get(name, 0.15))
        if name == "squeeze" and gap < 0.3:
            tolerance = 0.2
        yield Row(f"{n_dims}D at a wall, {what}, gap {gap} h, from "
                  f"{min(ratios):.2f} to {max(ratios):.2f}",
                  f"D/h = {2*radius}, step {step}", should,
                  sum(ratios)/len(ratios), tolerance if gap >= 0.1 else None,
                  minutes)


def spheres():
    """Three dimensions: squeeze."""
    return films(3, (8,), (10,), (3, 2, 1, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05))


LONG = {"wallFilms": films, "sphereWallFilms": spheres}
