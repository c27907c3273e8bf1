# SPDX-License-Identifier: GPL-3.0-or-later
"""What large steps and moving walls cost: the pressure of a flow that starts,
and the momentum of a channel full of discs. No published figures: a steady
value and a balance are the references."""

import itertools
import re

import results
from common import Case, Row, disc, placed, wall_layers

# A disc of 7 cells settles; density 2, steps of so many h^2/nu
STARTS = ((5.76, 1e-3), (57.6, 1e-2), (576, 0.1))

# Within this part of the steady speed it is there
NEAR = 0.05


def start():
    """Steps until a disc that settles from rest without inertia keeps its
    steady speed, which it would reach within a step."""
    steady = None
    for rate, step in STARTS:
        case = Case(
            f"start-{rate}", box=(0, 0, 1, 2), cells=(24, 48), viscosity=10,
            gravity="(0 -0.01 0)", shapes=disc(0.15, "density 2; E 1e5;"),
            placements=placed("disc", (0.5, 1.2)),
            properties="output { objectsEvery 1; }",
            deltaT=step, endTime=400*step, writeInterval=400*step)
        minutes = case.solve()
        speeds = [row["velocityY"] for row in case.objects()
                  if row["time"] > 0]
        if steady is None:
            steady = speeds[-1]
        far = [i for i, speed in enumerate(speeds, 1)
               if abs(speed/steady - 1) > NEAR]
        yield Row(f"disc starts to settle, dt nu/h^2 = {rate}, steps until "
                  "within 5 % of its speed", "d/h = 7", None,
                  far[-1] + 1 if far else 1, None, minutes)


def stress_over_force(name, reynolds, cells, end):
    """Stress of the walls over what drives a channel with neutrally buoyant
    discs on 30 % of the area, in the mean over the last two thirds of the time;
    minutes."""
    case = Case(
        name, box=(0, 0, 2, 1), cells=(2*cells, cells),
        viscosity=1/reynolds, cyclic="x",
        shapes=disc(0.1, "density 1; E 10;"),
        placements="a { type packed; shape disc; areaFraction 0.3; "
                   "wallGap 0.04; minimumGap 0.04; }",
        properties="drivingForce { type meanVelocity; "
                   "velocity (1 0 0); } output { log full; }",
        deltaT=0.2/cells, endTime=end, writeInterval=0.05)
    minutes = case.solve()
    log = results.read(case.path, "log.fsiPisoFoam")
    found = [float(x) for x in
             re.findall(r"driving acceleration ([-+.0-9e]+)", log)]
    found = found[len(found)//3:]
    times = [t for t in results.times(case.path) if float(t) >= end/3]
    stress = sum(sum(wall_layers(case, t)) for t in times)/len(times)
    stress *= case.values["viscosity"]/(case.spacing()/2)
    return stress*len(found)/sum(found), minutes


def driving():
    """The channel for so long that the momentum in it no longer counts."""
    for reynolds, cells in itertools.product((10, 100), (40, 80)):
        ratio, minutes = stress_over_force(
            f"driving{reynolds}-{cells}", reynolds, cells, 12)
        yield Row(f"channel with discs, Re {reynolds}, walls' stress over "
                  "the driving force", f"d/h = {cells//5}", 1, ratio, 0.003,
                  minutes, (f"driving {reynolds}", cells))


CASES = {"start": start, "driving": driving}
