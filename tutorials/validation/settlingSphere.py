# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres that settle or rise, in three dimensions.

A nylon sphere in a closed box of oil (ten Cate et al. 2002, Phys. Fluids 14,
4012): experiments E1 and E4; times from their figure 5a. Units are SI.

A light sphere that starts from rest follows, while it is slow, the equation of
Basset, Boussinesq and Oseen for an unbounded fluid:

    (s + 1/2) dv/dt = (1 - s) g - (9/2) (nu/a^2) v
                      - (9/2) sqrt(nu/(pi a^2)) int dv/dt'/sqrt(t - t') dt'
"""

import math

from common import Case, Row, at, disc, placed, sphere

# Density and viscosity of the fluid, largest speed, times at which the gap
# below is two and seven diameters, tolerance of the speed at 16 cells per
# diameter
EXPERIMENTS = {"E1": (970, 0.373, 0.0363, 2.804, 0.664, 0.05),
               "E4": (960, 0.058, 0.1226, 0.953, 0.289, 0.03)}

DIAMETER = 0.015

# The weight in the fluid is 23 Pa
KINDS = {"rigid": "type rigid; density 1120;", "stiff": "density 1120; E 1e5;"}


def oil(experiment, fifth, kind="rigid"):
    """The box with a number of cells to each 2 cm, run until the gap is below
    two diameters: rows of objects.csv, the minutes."""
    density, viscosity, speed, time = EXPERIMENTS[experiment][:4]
    h = 0.02/fifth
    case = Case(
        f"tenCate-{experiment}-{kind}-{fifth}", box=(0, 0, 0, 0.1, 0.16, 0.1),
        cells=(5*fifth, 8*fifth, 5*fifth), density=density,
        viscosity=viscosity/density, gravity="(0 -9.81 0)",
        shapes=sphere(DIAMETER/2, KINDS[kind]),
        placements=placed("sphere", (0.05, 8.5*DIAMETER, 0.05)),
        properties="output { objectsEvery 1; }",
        deltaT=0.2*h/speed, endTime=1.08*time, writeInterval=0.27*time)
    minutes = case.solve(20000)
    return case.objects(), minutes


def ten_cate(cells):
    """Largest speed and time of both experiments, at 11 or 22 cells to 2 cm."""
    for experiment, (*_, speed, time, start, fine) in EXPERIMENTS.items():
        for fifth in cells:
            rows, minutes = oil(experiment, fifth)
            grid = f"D/h = {DIAMETER*fifth/0.02:.3g}"
            tolerance = fine if fifth >= 21 else 0.06
            last, first = (at(rows, "centroidY", gap*DIAMETER, "time")
                           for gap in (2.5, 7.5))
            for what, reference, value, part in (
                    ("largest speed [m/s]", speed,
                     max(-row["velocityY"] for row in rows), tolerance),
                    ("time at gap 2 D [s]", time, last, 0.04),
                    ("time from gap 7 D to 2 D [s]", time - start,
                     last - first, 0.04)):
                what = f"settling sphere {experiment}, {what}"
                yield Row(what, grid, reference, value, part*reference, minutes,
                          (what, fifth))


def light_speed(ratio, end, steps=2000):
    """Speed by the equation above with a = nu = g = 1, at a time."""
    dt = end/steps
    basset = 4.5/math.sqrt(math.pi)
    # Integral of 1/sqrt(t - t') over the step k steps ago
    weights = [2*math.sqrt(dt)*(math.sqrt(k + 1) - math.sqrt(k))
               for k in range(steps)]
    rates, speed = [], 0
    for n in range(steps):
        history = sum(rate*weights[n - j] for j, rate in enumerate(rates))
        rates.append((1 - ratio - 4.5*speed - basset*history)
                     / (ratio + 0.5 + 4.5*dt + basset*weights[0]))
        speed += dt*rates[-1]
    return speed


def light():
    """A tenth of the fluid's density; no speed may pass Stokes' final one. The
    stiff one deforms by 1e-8, the shortest way measured is 2e-6."""
    ratio, gravity, cells = 0.1, 1e-3, 6
    for kind, material in (("rigid", "type rigid; density 0.1;"),
                           ("stiff", "density 0.1; E 1e5;")):
        case = Case(
            f"light-{kind}", box=(-5,)*3 + (5,)*3, cells=(10*cells,)*3,
            viscosity=1, gravity=f"(0 {-gravity} 0)",
            shapes=sphere(1, material), placements=placed("sphere", (0, 0, 0)),
            properties="output { objectsEvery 1; }", p_tolerance=1e-10,
            U_tolerance=1e-11, deltaT=0.002, endTime=0.5, writeInterval=0.5)
        minutes = case.solve()
        rows = case.objects()
        for time in (0.1, 0.5):
            yield Row(f"light sphere from rest, {kind}, speed over Basset's at "
                      f"t nu/a^2 = {time}", f"a/h = {cells}", 1,
                      at(rows, "time", time, "velocityY")
                      / (gravity*light_speed(ratio, time)), 0.03, minutes)
        final = gravity*(1 - ratio)*2/9
        yield Row(f"light sphere from rest, {kind}, largest speed beyond "
                  "Stokes' over it", f"a/h = {cells}", 0,
                  max(0, max(row["velocityY"] for row in rows)/final - 1),
                  0.01, minutes)


CASES = {"tenCate": lambda: ten_cate((11,)), "lightSphere": light}

LONG = {"tenCateFine": lambda: ten_cate((22,))}
