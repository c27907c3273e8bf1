# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscosity of suspensions of rigid spheres in a shear between walls five
diameters apart, at Re 0.1 with the radius and the shear rate (as Rosti, Brandt
and Mitra 2018, Phys. Rev. Fluids 3, 012301, who find Eilers' formula

    mu/mu_0 = (1 + 1.25 phi/(1 - phi/0.63))^2

in such a box). Lengths are radii, shear rate and density are 1.

Contact presses as hard as the flow, where a gap is half a cell. The default for
rigid bodies, which have no modulus, is density (h/dt)^2, 60 to 250 times as
much: it holds spheres a fifth of a radius apart, so that no film gets thin.
"""

import results
from common import Case, Row, sphere, wall_layers

SIDE = 10

VISCOSITY = 10

CONTACT = ("contact { range 1; lubrication { type Reynolds; } "
           f"law {{ type elastic; stiffness {VISCOSITY}; }} }}")


def eilers(phi):
    """Viscosity over that of the fluid."""
    return (1 + 1.25*phi/(1 - phi/0.63))**2


def viscosity(phi, cells, step, end):
    """Walls' stress over that of the fluid alone in the mean over the second
    half, and minutes; radius/h = cells."""
    half = SIDE/2
    case = Case(
        f"suspension-{phi}-{cells}-{step}", box=(-half,)*3 + (half,)*3,
        cells=(SIDE*cells,)*3, viscosity=VISCOSITY, cyclic="xz",
        walls={"top": f"({half} 0 0)", "bottom": f"({-half} 0 0)"},
        shapes=sphere(1, "type rigid; density 1;"),
        placements="a { type packed; shape sphere; "
                   f"volumeFraction {phi}; minimumGap 0.1; wallGap 0.1; }}",
        properties=CONTACT, deltaT=step, endTime=end, writeInterval=0.1)
    case.set_velocity(lambda x, y, z: (y, 0, 0))
    minutes = case.solve(40000)
    gradients = []
    for time in results.times(case.path):
        if float(time) >= end/2:
            lower, upper = wall_layers(case, time)
            gradients.append((lower - upper + 2*half)/case.spacing())
    return sum(gradients)/len(gradients), minutes


def suspension(fractions=(0.1, 0.2, 0.3), cells=4, end=10):
    """Each with two time steps."""
    for phi in fractions:
        for step in (0.01, 0.005):
            value, minutes = viscosity(phi, cells, step, end)
            yield Row(f"spheres at {phi:.0%} in shear, viscosity, "
                      f"step {step}", f"D/h = {2*cells}", eilers(phi), value,
                      0.1*eilers(phi), minutes)


LONG = {"suspension": suspension}
