# SPDX-License-Identifier: GPL-3.0-or-later
"""What the size of a time step costs in a flow whose walls move: one free disc
that nearly fills half of a channel in Stokes flow, as one of a suspension. No
published figures: the value extrapolated to small steps is the reference."""

import math

from common import Case, Field, Row, disc, placed
import results

# Young's modulus, over the driving pressure's scale of 1
MODULI = (("soft", 300), ("medium", 1e4), ("stiff", 1e6))

# h = 1/64 and nu = 1: dt nu/h^2 = 41 and its halves
CELLS, STEPS = 64, (0.01, 0.005, 0.0025, 0.00125)

# Entries of the coupling, the largest error of a step with them (with one pass
# it is only reported), and those whose small steps are the limit
COUPLINGS = {"one pass": ("passes 1;", None), "passes 4": ("passes 4;", 0.01)}
CONVERGED = "passes 20; passTolerance 0.0005;"

# Fourteen discs on 35 % of the same box, reported only
CROWD, SHARE, CROWD_STEPS = 14, 0.35, (0.01, 0.0025, 0.000625)


def mean_velocity(name, radius, modulus, placements, step, coupling,
                  start=0.8):
    """Mean velocity of the box in the mean from a start to 1 s; minutes."""
    case = Case(
        f"timeStep-{name}-{step}".replace(" ", ""), cells=(CELLS, CELLS),
        viscosity=1, cyclic="x",
        shapes=disc(radius, f"density 1; E {modulus};"),
        placements=placements,
        properties="drivingForce { type acceleration; "
                   "acceleration (12 0 0); } contact { range 1; } "
                   f"coupling {{ type solidImplicit; {coupling} }}",
        deltaT=step, endTime=1, writeInterval=0.02)
    minutes = case.solve()
    means = [sum(Field(case, "U", 0, t).values)/CELLS**2
             for t in results.times(case.path) if float(t) > start - 0.01]
    ends = (means[0] + means[-1])/2
    return (sum(means) - ends)/(len(means) - 1), minutes


def single(name, modulus, step, what, coupling):
    """The same of the single disc."""
    return mean_velocity(f"{name}-{what}", 0.25, modulus,
                         placed("disc", (0.5, 0.35)), step, coupling)


def time_step():
    """Steps that are halved, against what the last two with many passes lead
    to."""
    for name, modulus in MODULI:
        ends = [single(name, modulus, step, "limit", CONVERGED)[0]
                for step in STEPS[-2:]]
        limit = 2*ends[1] - ends[0]
        for what, (coupling, near) in COUPLINGS.items():
            for step in STEPS:
                value, minutes = single(name, modulus, step, what, coupling)
                yield Row(f"{name} disc in Stokes flow, {what}, mean "
                          "velocity over that of small steps",
                          f"dt nu/h^2 = {step*CELLS**2:.3g}", 1, value/limit,
                          near, minutes,
                          (f"time step, {name}, {what}", round(1/step)))
    yield from crowd()


def crowd():
    """Many discs: no limit is known."""
    radius = (SHARE/(CROWD*math.pi))**0.5
    gap = 0.05*radius
    for what, (coupling, _) in COUPLINGS.items():
        for step in CROWD_STEPS:
            value, minutes = mean_velocity(
                f"crowd-{what}", radius, 1e4,
                "all { type packed; shape disc; "
                f"areaFraction {SHARE}; minimumGap {gap}; wallGap {gap}; }}",
                step, coupling, 0.5)
            yield Row(f"{CROWD} discs in Stokes flow, {what}, mean velocity",
                      f"dt nu/h^2 = {step*CELLS**2:.3g}", None, value, None,
                      minutes)


CASES = {"timeStep": time_step}
