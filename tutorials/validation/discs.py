# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs that settle: validation.md calls these cases 4a to 4e."""

import math

from common import Case, Row, at, disc, placed


def tank(name, cells, density, viscosity, centres, material="E 1e5;",
         **controls):
    """A closed box of 2 x 6 cm with discs of diameter 0.25 cm, d/h = cells;
    units are cm, g and s."""
    n = 8*cells
    return Case(
        name, box=(0, 0, 2, 6), cells=(n, 3*n), viscosity=viscosity,
        gravity="(0 -981 0)",
        shapes=disc(0.125, f"density {density}; {material}"),
        placements=placed("disc", *centres), **controls)


def slow():
    """Density ratio 1.25 (Glowinski 2001, Wan and Turek 2006, Koblitz 2017)"""
    for cells in (8, 16, 32):
        case = tank(f"settling1.25-{cells}", cells, 1.25, 0.1, [(1, 4)],
                    properties="output { objectsEvery 10; }",
                    deltaT=8e-3/cells, endTime=0.65, writeInterval=0.1)
        minutes = case.solve()
        rows = case.objects()
        grid = f"d/h = {cells}"
        for what, reference, value, tolerance in (
                ("largest speed [cm/s]", 5.55,
                 max(-row["velocityY"] for row in rows), 0.15),
                ("time at y = 2 cm [s]", 0.434,
                 at(rows, "centroidY", 2, "time"), 0.010),
                ("time at y = 1 cm [s]", 0.613,
                 at(rows, "centroidY", 1, "time"), 0.015)):
            yield Row(f"settling disc 1.25, {what}", grid, reference, value,
                      tolerance, minutes,
                      (f"settling disc 1.25, {what}", cells))


# Bergmann 2014: time, height
FAST = ((0.0310, 3.925), (0.0548, 3.767), (0.0762, 3.573), (0.1028, 3.290),
        (0.1214, 3.065), (0.1467, 2.766), (0.1712, 2.455), (0.1950, 2.148))


def fast():
    """Density ratio 1.5, to below mid height (Bergmann 2014)."""
    for cells in (16, 32):
        case = tank(f"settling1.5-{cells}", cells, 1.5, 0.01, [(1, 4)],
                    properties="output { objectsEvery 2; }",
                    deltaT=8e-3/cells, endTime=0.2, writeInterval=0.05)
        minutes = case.solve()
        rows = case.objects()
        worst = max((at(rows, "time", t, "centroidY") - y for t, y in FAST),
                    key=abs)
        yield Row("settling disc 1.5, height less the curve's [cm]",
                  f"d/h = {cells}", 0, worst, 0.10 if cells == 32 else None,
                  minutes)
        yield Row("settling disc 1.5, largest speed to mid height [cm/s]",
                  f"d/h = {cells}", 13.1,
                  max(-row["velocityY"] for row in rows),
                  0.7 if cells == 32 else None, minutes)


def pair():
    """Two discs: drafting and kissing (Glowinski 2001, Uhlmann 2005, Koblitz
    2017); ranges of the three."""
    for cells in (16, 32):
        case = tank(f"kissing-{cells}", cells, 1.5, 0.01,
                    [(0.999, 5), (1.001, 4.5)],
                    # Contact begins at 3 % of d and 1.6 %
                    properties="contact { range 0.5; } "
                               "output { objectsEvery 2; }",
                    deltaT=6e-3/cells, endTime=0.2, writeInterval=0.02)
        minutes = case.solve()
        rows = case.objects()
        trail = [row for row in rows if row["object"] == 0]
        lead = [row for row in rows if row["object"] == 1]
        apart = [{"time": a["time"], "distance": math.dist(
                     (a["centroidX"], a["centroidY"]),
                     (b["centroidX"], b["centroidY"]))/0.25}
                 for a, b in zip(trail, lead)]
        checked = cells == 32
        for what, reference, value, tolerance in (
                ("time of kissing (gap 5 % of d) [s]", 0.17,
                 at(apart, "distance", 1.05, "time"), 0.015),
                ("trailing disc at 0.14 s, from the top [cm]", 2.30,
                 6 - at(trail, "time", 0.14, "centroidY"), 0.08),
                ("largest speed of the trailing disc [cm/s]", 19.5,
                 max(-row["velocityY"] for row in trail), 2),
                ("smallest distance over d", 1,
                 min(row["distance"] for row in apart), 0.06)):
            yield Row(f"two discs, {what}", f"d/h = {cells}", reference, value,
                      tolerance if checked else None, minutes)


def stokes():
    """Disc in the middle of a channel four diameters wide, Re 0.002: Faxen's
    series (Wang and Liu 2004)."""
    k, radius, gravity = 0.25, 0.125, 1.0
    bracket = -math.log(k) - 0.9157 + 1.7244*k**2 - 1.7302*k**4
    viscosity = 0.05
    for cells in (8, 16, 32):
        # Length of 8 widths, settling over 4 % of the diameter
        speed = 0.01*gravity*radius**2/(4*viscosity)*bracket
        n = cells*4
        case = Case(
            f"stokes-{cells}", box=(0, 0, 1, 8), cells=(n, 8*n),
            viscosity=viscosity, gravity=f"(0 {-gravity} 0)",
            shapes=disc(radius, "density 1.01; E 1e3;"),
            placements=placed("disc", (0.5, 4)),
            deltaT=0.5/cells, endTime=20, writeInterval=4)
        minutes = case.solve()
        yield Row("disc in a channel, Stokes flow, speed over Faxen's",
                  f"d/h = {cells}", 1,
                  -case.objects()[-1]["velocityY"]/speed,
                  0.02 if cells >= 16 else None, minutes,
                  ("Stokes disc", cells))


def ring(case, inner, outer, height):
    """Writes the outline of a ring about the origin, constant/ring.csv. It is
    one loop: the ring has a slit at a height, a hundredth of a cell wide."""
    half = 0.005*case.spacing()
    n = 720
    points = []
    for radius, side in ((outer, 1), (inner, -1)):
        # From the slit to its other side, and back inside
        first = math.asin((height + side*half)/radius)
        last = math.asin((height - side*half)/radius)
        first, last = ((first, last + 2*math.pi) if side > 0
                       else (first + 2*math.pi, last))
        points += [(radius*math.cos(a), radius*math.sin(a))
                   for a in (first + (last - first)*i/n for i in range(n + 1))]
    case.text("constant/ring.csv",
              "".join(f"{x!r},{y!r}\n" for x, y in points))


def container():
    """Drag of a disc in the middle of a round container, Stokes flow; exact:
    4 pi mu U/(ln(R/a) - (R^2 - a^2)/(R^2 + a^2))."""
    a, R, speed = 0.4, 1.0, 1e-3
    exact = 4*math.pi/(math.log(R/a) - (R*R - a*a)/(R*R + a*a))
    for cells in (8, 16, 32):
        h = 2*a/cells
        half = R + 4*h
        n = round(2*half/h)
        case = Case(
            f"container-{cells}", box=(-half, -half, half, half), cells=(n, n),
            viscosity=1, shapes=disc(
                a, "density 1; E 1e3;",
                f"motion {{ type translating; velocity ({speed} 0 0); }}")
            + "ring { shape { type polygon; file \"constant/ring.csv\"; } "
              "material { density 1; E 1e3; } motion { type fixed; } }",
            placements="all { type listed; objects ("
                       "{ shape disc; centre (0 0 0); } "
                       "{ shape ring; centre (0 0 0); }); }",
            properties="output { objectsEvery 1; }",
            deltaT=0.08/cells, endTime=0.5, writeInterval=0.5)
        ring(case, R, R + 3.5*h, 0.25*h)
        minutes = case.solve()
        force = [row["forceX"] for row in case.objects()
                 if row["shape"] == "disc"][-1]
        yield Row("disc in a round container, Stokes flow, drag over exact",
                  f"d/h = {cells}", 1, -force/(h*speed*exact),
                  0.02 if cells >= 16 else None, minutes,
                  ("container", cells))


CASES = {"settling1.25": slow, "settling1.5": fast, "kissing": pair,
         "stokes": stokes, "container": container}
