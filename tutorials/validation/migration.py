# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc as heavy as the fluid moves across a channel: in Couette flow to its
middle (Feng, Hu and Joseph 1994), in Poiseuille flow to 0.27 of its width
(Segre and Silberberg; Pan and Glowinski 2002).

The channel is periodic, the disc is at rest at the start; set-up and curves are
those stored with the repository NaokiHori/EllipsesInFlows, examples case1 (one
width long there, four here) and case2.
"""

from common import Case, Row, at, disc, placed

# Time, height: Feng et al. 1994
COUETTE = ((20.01, 0.3485), (30.07, 0.3916), (40.04, 0.4234), (50.00, 0.4474),
           (60.04, 0.4643))

# Distance, height: Pan and Glowinski 2002
POISEUILLE = ((2.51, 0.3890), (5.00, 0.3628), (7.49, 0.3286), (10.0, 0.2948),
              (12.5, 0.2740), (15.0, 0.2695), (17.5, 0.2702))


def channel(name, cells, height, length=1, **parameters):
    """A periodic channel of width 1 with a disc of diameter 0.25, D/h = cells,
    at a height."""
    n = 4*cells
    return Case(
        name, box=(0, 0, length, 1), cells=(length*n, n), cyclic="x",
        shapes=disc(0.125, "density 1; E 100;"),
        placements=placed("disc", (0.5*length, height)), **parameters)


def travelled(rows):
    """Rows with "distance", along the channel: the centre's column jumps by a
    period."""
    distance, last = 0, rows[0]["centroidX"]
    for row in rows:
        step = row["centroidX"] - last
        distance += step - round(step)
        last = row["centroidX"]
        row["distance"] = distance
    return rows


def largest(rows, key, curve):
    """Largest difference of the height from a curve."""
    return max((at(rows, key, s, "centroidY") - y for s, y in curve), key=abs)


def couette():
    """Re 40, from the speed between the walls and the width. Period and time
    step matter here, see README."""
    for cells in (8, 16):
        case = channel(
            f"couette-{cells}", cells, 0.25, length=4, viscosity=1/40,
            walls={"top": "(0.5 0 0)", "bottom": "(-0.5 0 0)"},
            properties="output { objectsEvery 10; }",
            deltaT=0.08/cells, endTime=61, writeInterval=61)
        case.set_velocity(lambda x, y: (y - 0.5, 0))
        minutes = case.solve()
        rows = case.objects()
        tolerance = 0.008 if cells >= 16 else None
        what = "disc in Couette flow, height"
        yield Row(f"{what} at t = 40", f"D/h = {cells}", 0.4234,
                  at(rows, "time", 40.04, "centroidY"), tolerance, minutes,
                  (f"{what} at 40", cells))
        yield Row(f"{what} less the curve's, t = 20 to 60", f"D/h = {cells}",
                  0, largest(rows, "time", COUETTE), tolerance, minutes,
                  (f"{what} off", cells))


def poiseuille():
    """Started from rest by a pressure gradient; the empty channel's largest
    speed would be 0.068, Re 160."""
    for cells in (8, 16):
        case = channel(
            f"poiseuille-{cells}", cells, 0.4, viscosity=1/2334,
            properties="output { objectsEvery 10; } drivingForce "
                       "{ type acceleration; acceleration (2.337e-4 0 0); }",
            deltaT=1.6/cells, endTime=750, writeInterval=750)
        minutes = case.solve()
        rows = travelled(case.objects())
        tolerance = 0.008 if cells >= 16 else None
        what = "disc in Poiseuille flow, height"
        yield Row(f"{what} at last", f"D/h = {cells}", 0.2723,
                  rows[-1]["centroidY"], tolerance, minutes,
                  (f"{what} at last", cells))
        yield Row(f"{what} less the curve's", f"D/h = {cells}", 0,
                  largest(rows, "distance", POISEUILLE), None, minutes,
                  (f"{what} off", cells))


CASES = {"couette": couette, "poiseuille": poiseuille}
