# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc settles on a wall in Stokes flow, in gaps below a cell: time from the
gap 1/16 of its diameter to 1/48, with lubrication and without.

Exact for a cylinder beside a wall (Jeffrey and Onishi, The slow motion of a
cylinder next to a plane wall, Q. J. Mech. Appl. Math. 34, 1981): the drag per
length is 4 pi mu V/(a - tanh a) with cosh a = 1 + gap/radius.
"""

import math

from common import Case, Row, at, disc, placed

RADIUS = 0.5
GRAVITY = 9.5
GAPS = (1/16, 1/48)


def exact():
    """Time between the gaps: the integral of 1/V, with weight less buoyancy of
    a disc of twice the fluid's density 1; viscosity 1."""
    weight = GRAVITY*math.pi*RADIUS**2
    n = 2000
    step = (GAPS[0] - GAPS[1])/n
    time = 0
    for i in range(n):
        a = math.acosh(1 + (GAPS[1] + (i + 0.5)*step)/RADIUS)
        time += step*4*math.pi/(weight*(a - math.tanh(a)))
    return time


def settle(cells, lubrication):
    """Row of d/h = cells; contact itself pushes next to nothing."""
    case = Case(
        f"lubrication-{cells}-{'with' if lubrication else 'without'}",
        box=(0, 0, 6, 4), cells=(6*cells, 4*cells), viscosity=1,
        gravity=f"(0 {-GRAVITY} 0)",
        shapes=disc(RADIUS, "density 2; E 1e6;"),
        placements=placed("disc", (3, RADIUS + 1.5*GAPS[0])),
        properties="contact { range 1; law { type elastic; stiffness 1e-9; }"
                   + (" lubrication { type Reynolds; }" if lubrication else "")
                   + " } output { objectsEvery 1; }",
        deltaT=0.08/cells, endTime=10, writeInterval=10)
    minutes = case.solve()
    start, end = (at(case.objects(), "centroidY", RADIUS + gap, "time")
                  for gap in GAPS)
    return Row("disc on a wall, time from gap 1/16 to 1/48, "
               + ("with" if lubrication else "without") + " lubrication",
               f"d/h = {cells}", exact(), end - start, None, minutes)


def film():
    """Rows without a tolerance: what a film below a cell lacks is the mesh's
    own part, see README."""
    for cells in (8, 16, 32):
        for lubrication in (False, True):
            yield settle(cells, lubrication)


CASES = {"lubrication": film}
