# SPDX-License-Identifier: GPL-3.0-or-later
"""Vessels with the fluid inside: closed surfaces in a file, which reach out of
the domain at their ends. A straight tube that is cyclic along its axis, and a
tube that is bent by a right angle, from an inlet to an outlet with given
pressures. Lengths are radii of the tube, density and viscosity 1.

The flow of Hagen and Poiseuille in the bent tube has the length of its axis.
In Stokes flow the bend changes it by the part (radius/radius of the bend)^2/48
(Dean 1927), which is below 0.3 %.
"""

import math

from common import Case, Row
from fixedWalls import flux
import results
import stlFile

BEND = 3

PRESSURE = 0.01

VESSEL = """
vessel
{
    shape    { type surface; file "vessel.stl"; inside yes; }
    material { type rigid; density 1; }
    motion   { type fixed; }
}
"""


def write_vessel(path, axis, n):
    """Writes a tube about an axis as STL: places and unit vectors along it in
    the plane of x and y. Rings are polygons with the area of the circle."""
    radius = (2*math.pi/(n*math.sin(2*math.pi/n)))**0.5
    rings = []
    for (x, y), (u, v) in axis:
        rings.append([(x - v*radius*math.cos(a), y + u*radius*math.cos(a),
                       radius*math.sin(a))
                      for a in (2*math.pi*i/n for i in range(n))])
    triangles = []
    for one, two in zip(rings, rings[1:]):
        for i in range(n):
            j = (i + 1) % n
            triangles += [(one[i], two[j], two[i]), (one[i], one[j], two[j])]
    for (place, _), ring, turn in ((axis[0], rings[0], -1),
                                   (axis[-1], rings[-1], 1)):
        for a, b in zip(ring, ring[1:] + ring[:1]):
            triangles.append(((*place, 0), a, b)[::turn])
    stlFile.write(path, triangles)


def straight(cells):
    """Flow over pi G/8; radius/h = cells."""
    h = 1/cells
    half = (cells + 3)*h
    case = Case(
        f"vessel-straight-{cells}", box=(0, -half, -half, 8*h, half, half),
        cells=(8, 2*cells + 6, 2*cells + 6), cyclic="x", viscosity=1,
        deltaT=0.1*h, endTime=2, writeInterval=2, shapes=VESSEL,
        placements="a { type inPlace; shape vessel; }",
        properties="drivingForce { type acceleration; acceleration (1 0 0); }")
    write_vessel(f"{case.path}/vessel.stl",
                 [((0.0013*h + x, -0.0017), (1, 0))
                  for x in (-1 + i*(2 + 8*h)/24 for i in range(25))], 8*cells)
    minutes = case.solve()
    return flux(case)*8/math.pi, minutes


def bent(cells):
    """Flow over that of the straight tube of the same length."""
    h = 1/cells
    side = BEND + (cells + 2)*h
    n = round(side/h)
    flow = "type pressureInletOutletVelocity; value uniform (0 0 0);"
    case = Case(
        f"vessel-bent-{cells}", box=(0, 0, -(cells + 2)*h, n*h, n*h,
                                     (cells + 2)*h),
        cells=(n, n, 2*cells + 4), viscosity=1, deltaT=0.1*h, endTime=2,
        writeInterval=2, shapes=VESSEL,
        placements="a { type inPlace; shape vessel; }",
        open={"bottom": (flow, f"type fixedValue; value uniform {PRESSURE};"),
              "left": ("type zeroGradient;",
                       "type fixedValue; value uniform 0;")})
    axis = [((BEND, y), (0, 1)) for y in (-1, -0.75, -0.5, -0.25)]
    for i in range(8*BEND + 1):
        a = math.pi/2*i/(8*BEND)
        axis.append(((BEND*math.cos(a), BEND*math.sin(a)),
                     (-math.sin(a), math.cos(a))))
    axis += [((x, BEND), (-1, 0)) for x in (-0.25, -0.5, -0.75, -1)]
    write_vessel(f"{case.path}/vessel.stl", axis, 8*cells)
    minutes = case.solve()
    rows = results.read(case.path, results.times(case.path)[-1], "phi")
    start = rows.index("left", rows.index("boundaryField"))
    start = rows.index("(", start) + 1
    outflow = sum(map(float, rows[start:rows.index(")", start)].split()))
    length = math.pi/2*BEND
    return outflow*8*length/(math.pi*PRESSURE), minutes


def vessel():
    """Both tubes."""
    for name, flow, ladder in (("straight", straight, (5, 10)),
                               ("bent", bent, (5, 8))):
        for cells in ladder:
            value, minutes = flow(cells)
            yield Row(f"vessel, {name} tube, flow over Hagen and Poiseuille's",
                      f"R/h = {cells}", 1, value, 0.02, minutes,
                      (f"{name} vessel", cells))


CASES = {"vessel": vessel}
