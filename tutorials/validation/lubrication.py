# SPDX-License-Identifier: GPL-3.0-or-later
"""Films below a cell in Stokes flow: a disc and a sphere that settle on a wall,
and two that approach each other under a force. Time in which the gap falls from
h to h/3, with a radius of 4 h, over the exact one.

Exact drag over mu V: of a disc beside a wall 4 pi/(a - tanh a), cosh a = 1 +
gap/radius (Jeffrey and Onishi, Q. J. Mech. Appl. Math. 34, 1981); of a sphere
beside a wall and of two equal spheres Brenner's series (Chem. Eng. Sci. 16,
1961); of two discs the table of resistances.py. The load is such that the way
takes thirty steps, whatever the step is.
"""

import math

import resistances
from common import Case, Row, at, body

# Lengths are cells
RADIUS = 4
VISCOSITY = 1e6
STEPS = (1, 10, 40)
# nu t/h^2
TIME = 1200

# Gap at the start
START = 1.5


def series(term, alpha):
    """Brenner's sum."""
    return 4/3*math.sinh(alpha)*sum(
        n*(n + 1)/((2*n - 1)*(2*n + 3))*(term(n, alpha) - 1)
        for n in range(1, 200))


def beside_wall(n, a):
    """Term of a sphere that approaches a wall."""
    return ((2*math.sinh((2*n + 1)*a) + (2*n + 1)*math.sinh(2*a))
            / (4*math.sinh((n + 0.5)*a)**2 - ((2*n + 1)*math.sinh(a))**2))


def of_two(n, a):
    """Term of two spheres that approach each other."""
    return ((4*math.cosh((n + 0.5)*a)**2 + ((2*n + 1)*math.sinh(a))**2)
            / (2*math.sinh((2*n + 1)*a) - (2*n + 1)*math.sinh(2*a)))


def disc_beside_wall(gap):
    """Drag per length over mu V."""
    a = math.acosh(1 + gap)
    return 4*math.pi/(a - math.tanh(a))


def two_discs(gap):
    """Drag per length of one of them over mu V, by the table."""
    known = sorted((row["gap"], row["squeezeForce"])
                   for row in resistances.exact().values())
    for (low, first), (high, last) in zip(known, known[1:]):
        if low <= gap <= high:
            part = math.log(gap/low)/math.log(high/low)
            return first*(last/first)**part
    raise ValueError(gap)


# By the number of dimensions and of bodies: drag over mu V, of spheres over
# mu V and the radius, by the gap over the radius
DRAGS = {
    (2, 1): disc_beside_wall,
    (2, 2): two_discs,
    (3, 1): lambda gap: 6*math.pi*series(beside_wall, math.acosh(1 + gap)),
    (3, 2): lambda gap: 6*math.pi*series(of_two, math.acosh(1 + gap/2)),
}


def exact(n_dims, n_bodies):
    """Time from the gap h to h/3, times the force over mu."""
    n = 500
    step = (1 - 1/3)/n
    size = RADIUS if n_dims == 3 else 1
    return sum(DRAGS[n_dims, n_bodies]((1/3 + (i + 0.5)*step)/RADIUS)
               for i in range(n))*step*size/n_bodies


def approach(n_dims, n_bodies, step):
    """Row of a step, dt nu/h^2."""
    name = {2: "disc", 3: "sphere"}[n_dims]
    time = TIME/VISCOSITY
    force = VISCOSITY*exact(n_dims, n_bodies)/time
    side = 10*RADIUS
    across = [side/2 + 0.27]*(n_dims - 1)
    shapes = placements = ""
    for i in range(n_bodies):
        sign = 2*i - 1 if n_bodies == 2 else -1
        load = [-sign*force if n_bodies == 2 else -force, 0, 0]
        x = (side/2 + 0.41 + sign*(RADIUS + START/2) if n_bodies == 2
             else RADIUS + START)
        shapes += body(
            f"b{i}", f"{'circle' if n_dims == 2 else 'sphere'}; "
            f"radius {RADIUS};", "type rigid; density 1;",
            "motion {{ type free; force constant ({!r} {} {}); }}".format(
                *load))
        centre = " ".join(map(repr, [x, *across, 0][:3]))
        placements += (f"p{i} {{ type listed; shape b{i}; objects "
                       f"({{ centre ({centre}); }}); }}\n")
    case = Case(
        f"film-{n_dims}-{n_bodies}-{step}", box=(0,)*n_dims + (side,)*n_dims,
        cells=(side,)*n_dims, viscosity=VISCOSITY, shapes=shapes,
        placements=placements,
        properties="output { objectsEvery 1; }", timePrecision=12,
        deltaT=step/VISCOSITY, endTime=1.8*time, writeInterval=1)
    minutes = case.solve()
    gaps = []
    rows = case.objects()
    for i in range(0, len(rows), n_bodies):
        x = [row["centroidX"] for row in rows[i:i + n_bodies]]
        gaps.append({"time": rows[i]["time"],
                     "gap": x[1] - x[0] - 2*RADIUS if n_bodies == 2
                     else x[0] - RADIUS})
    start, end = (at(gaps, "gap", gap, "time") for gap in (1, 1/3))
    what = (f"two {name}s that approach each other" if n_bodies == 2
            else f"a {name} that settles on a wall")
    return Row(f"{what}, time from gap h to h/3 over the exact one",
               f"D/h = {2*RADIUS}, step {step}", 1, (end - start)/time, 0.1,
               minutes)


def film():
    """Bodies and steps."""
    for n_dims, n_bodies in DRAGS:
        for step in STEPS:
            yield approach(n_dims, n_bodies, step)


CASES = {"lubrication": film}
