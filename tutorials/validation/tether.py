# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere on a spring in a stream at Re 100: it has half the density of the
fluid, and rises and drifts until the spring's force is that of drag and
buoyancy.

The spring has no length when it is slack, and the sphere does not turn. So drag
D and buoyancy B give the extension sqrt(D^2 + B^2)/k of the spring, and the
tangent D/B of its angle to the vertical; the part of the extension along the
stream is D/k. The drag coefficients of a sphere in an unbounded stream are by
Clift, Grace and Weber (1978, table 5.2), 24/Re (1 + 0.1935 Re^0.6305) = 1.087,
and by Schiller and Naumann (1933), 24/Re (1 + 0.15 Re^0.687) = 1.092.

The sides of the box move with the stream. Their effect is taken as proportional
to the part of the box that the sphere blocks, and the one of the mesh as
proportional to h and to h^2; a wider box and a finer mesh give the limit. Its
tolerance is 2 %: 0.5 % between the references, 0.8 % if the effect of the sides
goes with the third power of the width, and the rest for the box's ends and what
is left of the swing.
"""

import math

from common import Case, Row, placed, sphere

REYNOLDS, STIFFNESS, RATIO, GRAVITY = 100, 1.2, 0.5, 1.64

DRAG = {
    "Clift": 24/REYNOLDS*(1 + 0.1935*REYNOLDS**0.6305),
    "Schiller": 24/REYNOLDS*(1 + 0.15*REYNOLDS**0.687),
}

STREAM = "(1 0 0)"


def hang(cells, width, end=16):
    """Mean extension of the spring in x and y over the last third of the time,
    about one period, with so many cells to the diameter in a box so many
    diameters wide; and the minutes."""
    case = Case(
        f"tether-{cells}-{width}",
        box=(-5, -width/2, -width/2, 9, width/2, width/2),
        cells=(14*cells, width*cells, width*cells), viscosity=1/REYNOLDS,
        gravity=f"(0 {-GRAVITY} 0)", velocity=STREAM,
        walls=dict.fromkeys(("bottom", "top", "back", "front"), STREAM),
        open={"left": (f"type fixedValue; value uniform {STREAM};",
                       "type zeroGradient;"),
              "right": ("type zeroGradient;",
                        "type fixedValue; value uniform 0;")},
        properties="output { objectsEvery 1; }",
        shapes=sphere(0.5, f"type rigid; density {RATIO};",
                      "motion { type free; rotations (); } "
                      "hold { spring { type nearest; point (0 0.5 0); "
                      f"stiffness {STIFFNESS}; }} }}"),
        placements=placed("sphere", (0, 0)), deltaT=1/cells, endTime=end,
        writeInterval=end)
    minutes = case.solve()
    last = [row for row in case.objects() if row["time"] > 2*end/3]
    return [sum(row[f"centroid{axis}"] for row in last)/len(last)
            for axis in "XY"], minutes


def rows_of(grid, spring, minutes):
    """Part along the stream, length and angle of a spring, compared."""
    weight = (1 - RATIO)*GRAVITY*math.pi/6
    drag = DRAG["Clift"]*math.pi/8
    for what, reference, value in (
            ("drag coefficient", DRAG["Clift"],
             8/math.pi*STIFFNESS*spring[0]),
            ("extension over D", math.hypot(drag, weight)/STIFFNESS,
             math.hypot(*spring)),
            ("angle to the vertical [degrees]",
             math.degrees(math.atan2(drag, weight)),
             math.degrees(math.atan2(*spring)))):
        yield Row(f"sphere on a spring in a stream, {what} (Clift)", grid,
                  reference, value, None, minutes)


def tether():
    """Springs of three runs, and the limit of a fine mesh and a wide box."""
    coefficients, total = [], 0
    for cells, width in ((8, 6), (8, 9), (12, 6)):
        spring, minutes = hang(cells, width)
        total += minutes
        coefficients.append(8/math.pi*STIFFNESS*spring[0])
        yield from rows_of(f"D/h = {cells}, box {width} D wide", spring,
                           minutes)
    first, wide, fine = coefficients
    for order in (1, 2):
        limit = (first + (wide - first)/(1 - (6/9)**2)
                 + (fine - first)/(1 - (8/12)**order))
        for name, coefficient in DRAG.items():
            yield Row("sphere on a spring in a stream, drag coefficient "
                      f"({name})", f"limit of both, order {order} in h",
                      coefficient, limit, 0.02*coefficient, total)


LONG = {"tether": tether}
