# SPDX-License-Identifier: GPL-3.0-or-later
"""What the size of a time step costs in a flow whose walls move: one free disc
that nearly fills half of a channel in Stokes flow, as one of a suspension. No
published figures: the value extrapolated to small steps is the reference."""

from common import Case, Field, Row, disc, placed
import results

# Young's modulus, over the driving pressure's scale of 1
MODULI = (("soft", 300), ("medium", 1e4), ("stiff", 1e6))

# h = 1/64 and nu = 1: dt nu/h^2 = 41 and its halves
CELLS, STEPS = 64, (0.01, 0.005, 0.0025, 0.00125)

# Passes of a step, and the largest error of the largest step with them; with
# one pass it is only reported
PASSES = ((1, None), (8, 0.01))


def mean_velocity(modulus, step, passes):
    """Mean velocity of the box in the mean from 0.8 to 1 s; CPU minutes."""
    case = Case(
        f"timeStep-{modulus:g}-{step}-{passes}", cells=(CELLS, CELLS),
        viscosity=1, cyclic="x", shapes=disc(0.25, f"density 1; E {modulus};"),
        placements=placed("disc", (0.5, 0.35)),
        properties="drivingForce { type acceleration; "
                   "acceleration (12 0 0); } contact { range 1; } "
                   f"coupling {{ type solidImplicit; passes {passes}; }}",
        deltaT=step, endTime=1, writeInterval=0.02)
    minutes = case.solve()
    means = [sum(Field(case, "U", 0, t).values)/CELLS**2
             for t in results.times(case.path) if float(t) > 0.79]
    ends = (means[0] + means[-1])/2
    return (sum(means) - ends)/(len(means) - 1), minutes


def time_step():
    """Steps that are halved, against what the last two with all passes lead
    to."""
    for name, modulus in MODULI:
        found = {(step, passes): mean_velocity(modulus, step, passes)
                 for passes, _ in PASSES for step in STEPS}
        most = PASSES[-1][0]
        limit = 2*found[STEPS[-1], most][0] - found[STEPS[-2], most][0]
        for passes, near in PASSES:
            for step in STEPS:
                value, minutes = found[step, passes]
                yield Row(f"{name} disc in Stokes flow, passes {passes}, mean "
                          "velocity over that of small steps",
                          f"dt nu/h^2 = {step*CELLS**2:.3g}", 1, value/limit,
                          near, minutes,
                          (f"time step, {name}, {passes}", round(1/step)))


CASES = {"timeStep": time_step}
