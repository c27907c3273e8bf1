# SPDX-License-Identifier: GPL-3.0-or-later
"""Order in time with ddtSchemes backward, on one mesh, of what objects do: a
disc that settles, one that is carried along off the middle of a channel, as in
the migration cases, and a soft one that swings; in 3D a sphere in a channel.
The equations of a step are solved to the end, by many passes. The order is that
of differences between steps that are halved; there is no reference but 2."""

import math

from common import Case, disc, placed, Row

CELLS = 32

# Steps of each run
STEPS = (20, 40, 80, 160)

PASSES = ("coupling { passes 30; passTolerance 1e-7; } "
          "contact { range 1; } ")


def backward(name, n, end, **parameters):
    """A case of n steps, set up."""
    parameters["properties"] = PASSES + parameters.pop("properties", "")
    return Case(
        f"timeOrder-{name}-{n}", time_scheme="backward", p_tolerance=1e-10,
        U_tolerance=1e-10, deltaT=end/n, endTime=end, writeInterval=end,
        timePrecision=12, **parameters).set_up()


def settles(n):
    """Height of a disc, from rest under gravity."""
    case = backward(
        "settling", n, 0.4, box=(0, 0, 1, 2), cells=(CELLS, 2*CELLS),
        viscosity=0.05, gravity="(0 -1 0)", shapes=disc(0.2, "density 1.5; "
                                                        "E 1e3;"),
        placements=placed("disc", (0.47, 1.4)))
    minutes = case.solve_only()
    return [case.objects()[-1]["centroidY"]], minutes


def carried(n):
    """Place of a disc off the middle of a channel, from rest."""
    case = backward(
        "carried", n, 1, cells=(CELLS, CELLS), viscosity=0.1, cyclic="x",
        shapes=disc(0.15, "density 1; E 1e3;"),
        placements=placed("disc", (0.3, 0.35)),
        properties="drivingForce { type acceleration; "
                   "acceleration (1.2 0 0); }")
    minutes = case.solve_only()
    last = case.objects()[-1]
    return [last["centroidX"], last["centroidY"]], minutes


def swings(n):
    """Longer half axis of a soft disc that was stretched by a tenth."""
    case = backward(
        "swinging", n, 0.5, cells=(CELLS, CELLS), viscosity=0.01,
        shapes=disc(0.2, "type neoHookean; density 1; E 10;"),
        placements=placed("disc", (0.513, 0.487)))
    case.stretch("disc", 1.1, 1/1.1)
    minutes = case.solve_only()
    return [case.objects()[-1]["halfAxisA"]], minutes


def orders():
    """Observed orders, at most 2."""
    for what, names, run in (
            ("a disc that settles", ("height",), settles),
            ("a disc in a channel", ("place along it", "place across it"),
             carried),
            ("a soft disc that swings", ("longer half axis",), swings)):
        found, minutes = zip(*map(run, STEPS))
        for name, values in zip(names, zip(*found)):
            differences = [a - b for a, b in zip(values, values[1:])]
            for n, (a, b) in zip(STEPS, zip(differences, differences[1:])):
                order = math.log2(abs(a/b))
                yield Row(f"{what}, {name}: order in time, at most 2",
                          f"{n} to {4*n} steps (difference {abs(b):.1e})", 2,
                          min(order, 2), 0.2, sum(minutes))


CASES = {"timeOrder": orders}
