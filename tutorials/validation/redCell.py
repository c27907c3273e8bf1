# SPDX-License-Identifier: GPL-3.0-or-later
"""A red cell whose skin goes round in a viscous fluid (tank-treading): the
frequency that Tran-Son-Tay et al. 1984 measured, 0.217 of the shear rate, and
the axes of the cell as seen along the gradient of the flow, 6.5 +- 0.8 and
2.5 +- 0.3 micrometres at 57.1/s. The cell has the moduli of
etc/caseDicts/redCell, 6 mPa s inside, and a skin of 1e-7 Pa s m, so that skin
and inside dissipate about as much as each other (Fischer 1980, Biophys. J. 32,
863). The fluid has 35 mPa s, as dextran has in such experiments; the viscosity
of this one was not at hand, so that the axes have no tolerance."""

import math
import os

import results
from common import Case, Row

RATE = 57.1
MICRO = 1e-6
DENSITY = 1025
VISCOSITY = 35e-3
PRESET = os.path.abspath(os.path.join(
    os.path.dirname(__file__), "../../etc/caseDicts/redCell"))


def cell_in_shear(end, step):
    """Runs a cell between walls that slide, to a time over the shear rate;
    rows of objects.csv, and minutes."""
    half = [13*MICRO, 10*MICRO, 6*MICRO]
    wall = RATE*half[1]
    case = Case(
        "treading", box=[-x for x in half] + half, cells=(52, 40, 24),
        viscosity=VISCOSITY/DENSITY, density=DENSITY, cyclic="xz",
        walls={"top": f"({wall} 0 0)", "bottom": f"({-wall} 0 0)"},
        shapes="cell { shape { type biconcave; radius 3.91e-6; } material { "
               f'\n#include "{PRESET}"\nmembraneViscosity 1e-7; '
               "viscousModulus 5.7e-5; } }",
        placements="a { type listed; shape cell; objects "
                   "({ centre (0 0 0); rotation 15; }); }",
        properties="output { objectsEvery 10; }",
        deltaT=step/RATE, endTime=end/RATE, writeInterval=end/RATE,
        p_tolerance=1e-8, U_tolerance=1e-6)
    minutes = case.solve(20000)
    return case.objects(), minutes


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
    rows, minutes = cell_in_shear(30, 0.01)
    times = half_turns(rows)
    yield Row("red cell in 35 mPa s at 57.1/s: frequency of its skin over the "
              "shear rate", "h = 0.5 um", 0.217,
              (len(times) - 1)*math.pi/(times[-1] - times[0])/RATE, 0.0217,
              minutes)
    last = [row for row in rows if times[0] < row["time"] < times[-1]]
    for axis, key, reference in (
            ("long axis", "halfAxisA", 6.5),
            ("axis along the vorticity", "halfAxisB", 2.5)):
        yield Row(f"the same: half of its {axis} [um], mean", "h = 0.5 um",
                  reference, sum(row[key] for row in last)/len(last)/MICRO,
                  None, minutes)


LONG = {"treading": treading}
