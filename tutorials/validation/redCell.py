# SPDX-License-Identifier: GPL-3.0-or-later
"""A red cell in shear, with the moduli of etc/caseDicts/redCell and 6 mPa s
inside.

`treading`: its skin goes round in a viscous fluid (tank-treading): the
frequency that Tran-Son-Tay et al. 1984 measured, 0.217 of the shear rate, and
the axes of the cell as seen along the gradient of the flow, 6.5 +- 0.8 and
2.5 +- 0.3 micrometres at 57.1/s. The skin has 1e-7 Pa s m, so that skin and
inside dissipate about as much as each other (Fischer 1980, Biophys. J. 32,
863). The fluid has 35 mPa s, as dextran has in such experiments; the viscosity
of this one was not at hand, so that the axes have no tolerance.

`tumbling`: in plasma, a fifth as viscous as the inside, cells tumble as stiff
discs do (Goldsmith & Marlow 1972, Proc. R. Soc. B 182, 351), and a cell with
plasma inside lets its skin go round: the contrast decides (Keller & Skalak
1982, J. Fluid Mech. 120, 27). 260/s make the capillary number 0.34 of another
code's cell of contrast 5 and 5 uN/m at 500/s in an unbounded fluid: its angle
is -0.188 pi at the time 8 over the shear rate."""

import math
import os

import results
from common import Case, Row, at

MICRO = 1e-6
DENSITY = 1025
PRESET = os.path.abspath(os.path.join(
    os.path.dirname(__file__), "../../etc/caseDicts/redCell"))

TREADING_RATE = 57.1

# In plasma
TUMBLING_RATE = 260
PLASMA = 1.23e-3


def cell_in_shear(name, half, rate, viscosity, angle, material="", **more):
    """A case of a cell between walls that slide; half: of the box [um];
    angle: of the cell at first [degrees]; material: further entries."""
    wall = rate*half[1]*MICRO
    return Case(
        name, box=[-x*MICRO for x in half] + [x*MICRO for x in half],
        cells=tuple(4*x for x in half), viscosity=viscosity/DENSITY,
        density=DENSITY, cyclic="xz",
        walls={"top": f"({wall} 0 0)", "bottom": f"({-wall} 0 0)"},
        shapes="cell { shape { type biconcave; radius 3.91e-6; } material { "
               f'\n#include "{PRESET}"\n{material} }} }}',
        placements="a { type listed; shape cell; objects "
                   f"({{ centre (0 0 0); rotation {angle}; }}); }}",
        properties="output { objectsEvery 10; }", timePrecision=10, **more)


def half_turns(rows):
    """Times at which the marked node has gone round by half a turn once
    more."""
    angle, times, before = 0, [], rows[0]
    for row in rows[1:]:
        change = (row["phaseZ"] - before["phaseZ"] + math.pi) % (2*math.pi)
        after = angle + change - math.pi
        wanted = -math.pi*(len(times) + 1)
        if after <= wanted < angle:
            times.append(before["time"] + (row["time"] - before["time"])
                         * (wanted - angle)/(after - angle))
        angle, before = after, row
    return times


def treading():
    """The frequency and the axes."""
    case = cell_in_shear("treading", (13, 10, 6), TREADING_RATE, 35e-3, 15,
                         "membraneViscosity 1e-7; viscousModulus 5.7e-5;",
                         deltaT=0.01/TREADING_RATE, endTime=30/TREADING_RATE,
                         writeInterval=30/TREADING_RATE, p_tolerance=1e-8,
                         U_tolerance=1e-6)
    minutes = case.solve(20000)
    rows = case.objects()
    times = half_turns(rows)
    yield Row("red cell in 35 mPa s at 57.1/s: frequency of its skin over the "
              "shear rate", "h = 0.5 um", 0.217,
              (len(times) - 1)*math.pi/(times[-1] - times[0])
              / TREADING_RATE, 0.0217,
              minutes)
    last = [row for row in rows if times[0] < row["time"] < times[-1]]
    for axis, key, reference in (
            ("long axis", "halfAxisA", 6.5),
            ("axis along the vorticity", "halfAxisB", 2.5)):
        yield Row(f"the same: half of its {axis} [um], mean", "h = 0.5 um",
                  reference, sum(row[key] for row in last)/len(last)/MICRO,
                  None, minutes)


def turned(rows, key, period):
    """By how much an angle has turned from the first row on, for each row."""
    total = [0]
    for a, b in zip(rows, rows[1:]):
        total.append(total[-1] + math.remainder(b[key] - a[key], period))
    return total


def tumbling():
    """Half turns of the cell, and how far its skin has gone round it, with
    contrasts 5 and 1."""
    end = 15
    for contrast, wanted in ((5, 1), (1, 0)):
        case = cell_in_shear(
            f"tumbling-{contrast}", (10, 10, 6), TUMBLING_RATE, PLASMA, 34.4,
            f"innerViscosity {contrast*PLASMA};", deltaT=1e-5,
            endTime=end/TUMBLING_RATE, writeInterval=end/TUMBLING_RATE,
            p_tolerance=1e-4, U_tolerance=1e-4)
        case.set_velocity(lambda x, y, z: (TUMBLING_RATE*y, 0, 0))
        minutes = case.solve(20000)
        rows = case.objects()
        cell = turned(rows, "inclination", math.pi)
        skin = turned(rows, "phaseZ", 2*math.pi)
        what = f"red cell in plasma at {TUMBLING_RATE}/s, contrast {contrast}"
        grid = "h = 0.5 um"
        # How often it has pointed across the flow
        flips = math.floor(0.5 - (rows[0]["inclination"] + cell[-1])/math.pi)
        yield Row(f"{what}: half turns by the time {end} over the shear rate",
                  grid, wanted, flips, 0, minutes)
        yield Row(f"{what}: its angle at the time 8 over pi", grid,
                  -0.188 if contrast > 1 else None,
                  at(rows, "time", 8/TUMBLING_RATE, "inclination")/math.pi,
                  None, minutes)
        yield Row(f"{what}: turn of its skin less its own, over pi", grid,
                  None, (skin[-1] - cell[-1])/math.pi, None, minutes)


LONG = {"treading": treading, "tumbling": tumbling}
