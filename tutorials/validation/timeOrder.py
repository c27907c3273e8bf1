# SPDX-License-Identifier: GPL-3.0-or-later
"""Order in time with ddtSchemes backward, on one mesh, of what objects do: a
disc that settles, one that is carried along off the middle of a channel, as in
the migration cases, a soft one that swings, and the flow that drags a sphere
along. The equations of a step are solved to the end, by many passes.

The order is that of differences between steps that are halved, 2 at most. Where
a surface passes the centre of a cell it leaves a jump, which falls with the
mesh and not with the step: differences below 2e-4 of the way that was made are
reported only."""

import math

from common import Case, Field, Row, disc, placed, sphere
import results

CELLS = 32

NOISE = 2e-4

PASSES = ("coupling { passes 30; passTolerance 1e-7; } "
          "contact { range 1; } ")


def backward(name, n, end, **parameters):
    """A case of n steps, set up."""
    parameters["properties"] = PASSES + parameters.pop("properties", "")
    return Case(
        f"timeOrder-{name}-{n}", time_scheme="backward", p_tolerance=1e-10,
        U_tolerance=1e-10, deltaT=end/n, endTime=end, writeInterval=end,
        timePrecision=12, **parameters).set_up()


def driven(acceleration):
    """A force along x."""
    return ("drivingForce { type acceleration; "
            f"acceleration ({acceleration} 0 0); }}")


def settles(n):
    """Way of a disc, from rest under gravity."""
    case = backward(
        "settling", n, 2, box=(0, 0, 1, 2), cells=(CELLS, 2*CELLS),
        viscosity=0.05, gravity="(0 -1 0)",
        shapes=disc(0.2, "density 1.5; E 1e3;"),
        placements=placed("disc", (0.47, 1.4)))
    minutes = case.solve_only()
    return 1.4 - case.objects()[-1]["centroidY"], minutes


def carried(n):
    """Way of a disc off the middle of a channel, from rest."""
    case = backward(
        "carried", n, 1, cells=(CELLS, CELLS), viscosity=0.1, cyclic="x",
        shapes=disc(0.15, "density 1; E 1e3;"),
        placements=placed("disc", (0.3, 0.35)), properties=driven(1.2))
    minutes = case.solve_only()
    return case.objects()[-1]["centroidX"] - 0.3, minutes


def swings(n):
    """Elastic energy of a soft disc that was stretched by a tenth."""
    case = backward(
        "swinging", n, 0.5, cells=(CELLS, CELLS), viscosity=0.01,
        shapes=disc(0.2, "type neoHookean; density 1; E 10;"),
        placements=placed("disc", (0.513, 0.487)))
    case.stretch("disc", 1.1, 1/1.1)
    minutes = case.solve_only()
    return results.table(case.path, "global.csv")[-1]["elasticEnergy"], minutes


def dragged(n):
    """Mean velocity of a channel with a sphere, from rest."""
    case = backward(
        "sphere", n, 0.1, box=(0, 0, 0, 1, 1, 1), cells=(CELLS,)*3,
        viscosity=1, cyclic="xz",
        shapes=sphere(0.25, "type rigid; density 1;"),
        placements=placed("sphere", (0.5, 0.35, 0.5)), properties=driven(12))
    minutes = case.solve_only()
    return sum(Field(case, "U").values)/CELLS**3, minutes


RUNS = (("way of a disc that settles", settles, (20, 40, 80, 160)),
        ("way of a disc in a channel", carried, (20, 40, 80, 160)),
        ("energy of a soft disc that swings", swings, (40, 80, 160, 320)),
        ("flow around a sphere", dragged, (20, 40, 80)))


def orders():
    """The observed orders."""
    for what, run, steps in RUNS:
        values, minutes = zip(*map(run, steps))
        differences = [abs(a - b) for a, b in zip(values, values[1:])]
        for n, a, b in zip(steps, differences, differences[1:]):
            part = b/abs(values[-1])
            yield Row(f"{what}: order in time",
                      f"{n}, {2*n}, {4*n} steps (last difference {part:.0e})",
                      2, min(math.log2(a/b), 2),
                      0.2 if part > NOISE else None, sum(minutes))


CASES = {"timeOrder": orders}
