#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A case that is turned with all that is in it gives the same answer.

    turnedCases.py FOLDER

A box with a lid that moves, gravity, and bodies with tips, notches and thin
rims that meet each other. It is turned by 90 and 180 degrees in two dimensions,
and by 120 degrees about a diagonal in three. No choice of one of several faces
or places may depend on their direction. The equations of a step are solved to
the end. The number of cells is odd, so that the cell in the middle, which has
one colour in the sweeps, stays where it is.
"""

import math
import os
import sys

import fsiCase
import results

# Of the largest velocity or force of any body in the step
TOLERANCE = 1e-7

SIDES = {(0, 1, 0): "top", (0, -1, 0): "bottom", (1, 0, 0): "right",
         (-1, 0, 0): "left", (0, 0, 1): "front", (0, 0, -1): "back"}

# Rows of the rotation, and its quaternion
HALF = math.sqrt(0.5)
TURNS = {
    "not": (((1, 0, 0), (0, 1, 0), (0, 0, 1)), (1, 0, 0, 0)),
    "by 90 degrees": (((0, -1, 0), (1, 0, 0), (0, 0, 1)), (HALF, 0, 0, HALF)),
    "by 180 degrees": (((-1, 0, 0), (0, -1, 0), (0, 0, 1)), (0, 0, 0, 1)),
    "by 120 degrees": (((0, 0, 1), (1, 0, 0), (0, 1, 0)), (0.5, 0.5, 0.5, 0.5)),
}

STAR = "shape { type star; radius 0.12; amplitude 0.3; points 5; }"
LENS = "shape { type ellipsoid; semiAxes (0.22 0.18 0.09); } minimumCells 2;"
MATERIALS = {"rigid": "density 3; type rigid;", "soft": "density 3; E 200;"}

# Name, material, centre, velocity, and quaternion of each body
STARS = (
    ("rigid", (0.3, 0.32, 0), (1.5, 0.4, 0), (0.9962, 0, 0, 0.0872)),
    ("soft", (0.66, 0.36, 0), (-1.3, 0.2, 0), (0.9588, 0, 0, 0.284)),
    ("rigid", (0.43, 0.68, 0), (0.2, -1.7, 0), (0.8, 0, 0, 0.6)),
)
LENSES = (
    ("rigid", (0.3, 0.45, 0.5), (1, 0.1, 0.2), (0.9, 0.3, 0.2, 0.1)),
    ("soft", (0.7, 0.55, 0.45), (-1, 0, 0.1), (0.5, -0.2, 0.8, 0.3)),
)


def turned(rows, vector):
    """A vector after a rotation."""
    return tuple(sum(a*b for a, b in zip(row, vector)) for row in rows)


def back(rows, vector):
    """A vector before a rotation."""
    return turned(tuple(zip(*rows)), vector)


def product(p, q):
    """Quaternion of a rotation after another one, of length 1."""
    a, x, y, z = p
    b, u, v, w = q
    both = (a*b - x*u - y*v - z*w, a*u + x*b + y*w - z*v,
            a*v - x*w + y*b + z*u, a*w + x*v - y*u + z*b)
    length = math.hypot(*both)
    return tuple(c/length for c in both)


def words(vector):
    """A vector as OpenFOAM reads it."""
    return "(" + " ".join(f"{c:.17g}" for c in vector) + ")"


def rotation(quaternion, solid):
    """The entry of a rotation: in two dimensions the angle."""
    first, *others = quaternion
    if solid:
        return f"{{ quaternion ({first:.17g} {words(others)}); }}"
    return f"{math.degrees(2*math.atan2(others[2], first)):.17g};"


def placed(bodies, rows, quaternion, middle):
    """Entries of the placements of the bodies after a turn."""
    places = {name: "" for name in MATERIALS}
    for name, centre, velocity, turn in bodies:
        arm = tuple(c - m for c, m in zip(centre, middle))
        at = tuple(a + m for a, m in zip(turned(rows, arm), middle))
        both = product(quaternion, turn)
        places[name] += (
            f"{{ centre {words(at)}; velocity {words(turned(rows, velocity))};"
            f" rotation {rotation(both, middle[2] > 0)} }} ")
    return "\n".join(f"{name} {{ type listed; shape {name}; objects ({text}); "
                     "}" for name, text in places.items())


def rows_of(folder, turn, shape, bodies, **changes):
    """The rows of the bodies in a case that is turned, turned back."""
    rows, quaternion = TURNS[turn]
    middle = (0.5, 0.5, 0.5 if "box" in changes else 0)
    lid = SIDES[turned(rows, (0, 1, 0))]
    case = fsiCase.Case(
        os.path.join(folder, turn.replace(" ", "")),
        walls={lid: words(turned(rows, (1, 0, 0)))},
        gravity=words(turned(rows, (1, -6, 0))),
        shapes="\n".join(f"{name} {{ {shape} material {{ {material} }} }}"
                         for name, material in MATERIALS.items()),
        placements=placed(bodies, rows, quaternion, middle),
        properties="output { objectsEvery 1; }",
        p_tolerance=1e-13, U_tolerance=1e-13, **changes).set_up()
    case.run("fsiPisoFoam")
    return [{name: back(rows, [row[name + axis] for axis in "XYZ"])
             for name in ("velocity", "force")} | {"gap": row["smallestGap"]}
            for row in results.table(case.path, "objects.csv")]


def apart(first, other, bodies, name):
    """Largest difference of a vector in any step, over the largest one."""
    worst = 0
    for i in range(0, len(first), bodies):
        pairs = [(a, b) for x, y in zip(first[i:i + bodies],
                                        other[i:i + bodies])
                 for a, b in zip(x[name], y[name])]
        worst = max(worst, max(abs(a - b) for a, b in pairs)
                    / max(abs(a) for a, _ in pairs))
    return worst


def check(report, folder, name, turns, *case, **changes):
    """The case not turned, and turned."""
    os.makedirs(os.path.join(folder, name))
    bodies = len(case[1])
    first, *others = (rows_of(os.path.join(folder, name), turn, *case,
                              **changes) for turn in ("not", *turns))
    gap = min(row["gap"] for row in first)*changes["cells"][0]
    report.check(f"{name}: films between bodies", gap < 1, f"{gap} cells")
    for turn, other in zip(turns, others):
        for what in ("velocity", "force"):
            found = apart(first, other, bodies, what)
            print(f"    {name}, {turn}: {what} {found:.1e} apart")
            report.check(f"{name}, {turn}: {what}",
                         len(first) == len(other) and found < TOLERANCE,
                         f"{found} apart")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("stars", check, report, folder, "stars",
                   ("by 90 degrees", "by 180 degrees"), STAR, STARS,
                   cells=(33, 33), deltaT=0.003, endTime=0.12)
    report.attempt("lenses", check, report, folder, "lenses",
                   ("by 120 degrees",), LENS, LENSES,
                   box=(0, 0, 0, 1, 1, 1), cells=(17, 17, 17), deltaT=0.01,
                   endTime=0.15)


if __name__ == "__main__":
    main(sys.argv[1])
