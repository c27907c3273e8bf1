# SPDX-License-Identifier: GPL-3.0-or-later
"""An airfoil from a file of points that heaves and pitches in a fluid at rest:
the hovering ellipse of Wang, Birch and Dickinson (2004, Journal of Experimental
Biology 207, 449).

The ellipse has the chord c and is 0.12 c thick. Its centre moves along x as
1.4 c cos(2 pi t/T), its chord makes the angle pi/2 + pi/4 sin(2 pi t/T) with x;
Re = 75 with the largest speed U of the centre. Coefficients are over
0.6 rho U^2 c, as there. References are the mean over the second and third
period and the largest lift in them of two computations, Eldredge (2007, Journal
of Computational Physics 221, 626) by a vortex method, and Li, Dong and Liu
(2015, Journal of Fluids and Structures 58, 49), from the curves in the example
"flapping" of cuIBM (Barba group): 0.494, 1.297 and 0.490, 1.320. The curve of
Wang et al. there has less, 0.42 and 0.97. The box is closed, 10 c wide and
high; theirs are 30 c wide or without end.
"""

import math

from common import Case, Row, body

PERIOD = 2.8*math.pi

REFERENCES = {"Eldredge": (0.494, 1.297), "Li": (0.490, 1.320)}


def hover(cells):
    """The lift coefficient at all steps, with so many cells to a chord; and the
    minutes."""
    n, frequency = 10*cells, 1/PERIOD
    case = Case(
        f"airfoil-{cells}", box=(-5, -6, 5, 4), cells=(n, n), viscosity=1/75,
        properties="output { objectsEvery 1; }",
        shapes=body(
            "airfoil", 'polygon; file "constant/airfoil.csv";',
            "type rigid; density 1;",
            "minimumCells 0.5; motion { type several; motions ("
            f"{{ type oscillating; amplitude (1.4 0 0); frequency {frequency}; "
            f"phase {math.pi/2}; }} {{ type oscillating; rotationAmplitude "
            f"(0 0 {math.pi/4}); frequency {frequency}; }}); }}"),
        placements="airfoil { type listed; shape airfoil; "
                   "objects ({ centre (1.4 0 0); }); }",
        deltaT=PERIOD/(50*cells), endTime=3*PERIOD, writeInterval=PERIOD/4)
    points = [2*math.pi*i/200 for i in range(200)]
    case.text("constant/airfoil.csv", "".join(
        f"{0.06*math.cos(a)!r} {0.5*math.sin(a)!r}\n" for a in points))
    minutes = case.solve()
    return [(row["time"]/PERIOD, row["forceY"]/case.spacing()/0.6)
            for row in case.objects()], minutes


def airfoil():
    """Mean and largest lift."""
    for cells in (24, 48):
        rows, minutes = hover(cells)
        lift = [value for time, value in rows if time > 1]
        for name, (mean, largest) in REFERENCES.items():
            for what, reference, value in (
                    ("mean lift coefficient", mean, sum(lift)/len(lift)),
                    ("largest lift coefficient", largest, max(lift))):
                yield Row(f"ellipse that hovers at Re 75, {what} ({name})",
                          f"c/h = {cells}", reference, value,
                          0.1*reference if cells == 48 else None, minutes,
                          (f"{what} {name}", cells))


LONG = {"airfoil": airfoil}
