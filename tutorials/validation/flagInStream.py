# SPDX-License-Identifier: GPL-3.0-or-later
"""A flag behind a cylinder in a stream: the tests FSI of Turek and Hron (2006,
Lecture Notes in Computational Science and Engineering 53, 371).

The channel is 0.41 high, the cylinder has the radius 0.05 and the flag is
0.35 x 0.02. Both are one body here, whose nodes in the cylinder are clamped.
Its material is that of the flap alone (flap.py): neoHookean, with the moduli of
Poisson's ratio 0.4 in plane strain. The channel ends 1.6 behind the inlet,
where theirs is 2.5 long, and starts with the inflow's profile everywhere.
Forces are those on cylinder and flag, per depth. FSI2 is left out: it takes
long.
"""

import math

from common import Case, Row
from cylinder import risings
from flap import HALF_WIDTH, RIGHT, bar, free_end

HEIGHT, LENGTH, RADIUS = 0.41, 1.6, 0.05

CENTRE = (0.2, 0.2)


def outline(h):
    """Polygon of cylinder and flag, counter-clockwise."""
    first = math.asin(HALF_WIDTH/RADIUS)
    n = round((2*math.pi - 2*first)*RADIUS/h)
    turns = [first + (2*math.pi - 2*first)*i/n for i in range(n + 1)]
    return [(RIGHT, CENTRE[1] - HALF_WIDTH),
            (RIGHT, CENTRE[1] + HALF_WIDTH)] + [
        (CENTRE[0] + RADIUS*math.cos(a), CENTRE[1] + RADIUS*math.sin(a))
        for a in turns]


def flag(number, across, speed, shear, **controls):
    """The case, with so many cells across the flag; speed: mean of the
    inflow."""
    h = 2*HALF_WIDTH/across
    nx, ny = round(LENGTH/h), round(HEIGHT/h)
    inflow = [6*speed*y*(HEIGHT - y)/HEIGHT**2
              for y in ((j + 0.5)*h for j in range(ny))]
    profile = " ".join(f"({u:.10g} 0 0)" for u in inflow)
    case = Case(
        f"flag-{number}-{across}", box=(0, 0, nx*h, ny*h), cells=(nx, ny),
        density=1000, viscosity=1e-3,
        open={"left": ("type fixedValue; value nonuniform "
                       f"List<vector> {ny} ({profile});",
                       "type zeroGradient;"),
              "right": ("type zeroGradient;",
                        "type fixedValue; value uniform 0;")},
        properties="output { objectsEvery 1; }",
        shapes=bar("flag", shear, RADIUS + 0.1*h),
        placements="flag { type inPlace; shape flag; }", **controls)
    case.text("constant/flag.csv",
              "".join(f"{x!r} {y!r}\n" for x, y in outline(h)))
    case.set_velocity(lambda x, y: (
        6*speed*y*(HEIGHT - y)/HEIGHT**2, 0))
    return case


def steady(across=4):
    """FSI1: Re 20, the flag comes to rest."""
    case = flag(1, across, 0.2, 0.5e6, deltaT=0.04/across, endTime=12,
                writeInterval=2)
    minutes = case.solve()
    last = case.objects()[-1]
    x, y = free_end(case, "flag")[-1]
    for what, reference, value, part in (
            ("drag [N/m]", 14.29426, last["forceX"]/case.spacing(), 0.03),
            ("lift [N/m]", 0.7637460, last["forceY"]/case.spacing(), 0.1),
            ("displacement of the end in x [mm]", 0.02270493, 1e3*x, None),
            ("displacement of the end in y [mm]", 0.8208773, 1e3*y, 0.15)):
        yield Row(f"flag in a stream (FSI1), {what}", f"{across} cells across",
                  reference, value, part and part*reference, minutes)


def swing(across=4):
    """FSI3: Re 200, the flag swings. Mean and amplitude are those of the
    extremes in the last second, more than five periods."""
    case = flag(3, across, 2, 2e6, deltaT=0.004/across, endTime=4.5,
                writeInterval=0.02, time_scheme="backward")
    minutes = case.solve()
    rows = [row for row in case.objects() if row["time"] > 3.5]
    turns = risings([row["time"] for row in rows],
                    [row["centroidY"] for row in rows])
    yield Row("flag in a stream (FSI3), frequency [1/s]",
              f"{across} cells across", 5.3,
              (len(turns) - 1)/(turns[-1] - turns[0]), 0.1*5.3, minutes)
    x, y = zip(*[(1e3*x, 1e3*y) for x, y in free_end(case, "flag")[-50:]])
    drag, lift = ([row[key]/case.spacing() for row in rows]
                  for key in ("forceX", "forceY"))
    for what, values, mean, amplitude, mean_part, part in (
            ("displacement of the end in x [mm]", x, -2.69, 2.53, None, 0.1),
            ("displacement of the end in y [mm]", y, 1.48, 34.38, None, 0.1),
            ("drag [N/m]", drag, 457.3, 22.66, 0.06, None),
            ("lift [N/m]", lift, 2.22, 149.78, None, 0.15)):
        for name, reference, value, tolerance in (
                ("mean", mean, (max(values) + min(values))/2, mean_part),
                ("amplitude", amplitude, (max(values) - min(values))/2, part)):
            yield Row(f"flag in a stream (FSI3), {name} of the {what}",
                      f"{across} cells across", reference, value,
                      tolerance and tolerance*abs(reference), minutes)


def both():
    """FSI1 and FSI3."""
    yield from steady()
    yield from swing()


LONG = {"flag": both}
