#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of many triangles: a sphere of 50,000 is meshed in seconds (12 and
more nodes deep, where all of them are equally far), and a plate of a hundredth
of a cell is refused at once.

    fine.py FOLDER
"""

import math
import os
import struct
import sys

import fsiCase
from refused import refused

SHAPE = """a {{ shape {{ type surface; file "{}"; }} minimumCells 0;
    material {{ density 1100; E 1e4; }} }}"""
# Of processor time; the search of all triangles took 34 s
LIMIT = 15


def sphere(size):
    """Triangles of a sphere of this radius, 4 rows*(rows - 1) of them."""
    rows = 112

    def place(i, j):
        a, b = math.pi*i/rows, math.pi*(j % (2*rows))/rows
        ring = size*math.sin(a) if 0 < i < rows else 0.0
        return (ring*math.cos(b), ring*math.sin(b), size*math.cos(a))
    for i in range(rows):
        for j in range(2*rows):
            a, b = place(i, j), place(i + 1, j)
            c, d = place(i + 1, j + 1), place(i, j + 1)
            if i < rows - 1:
                yield a, b, c
            if i > 0:
                yield a, c, d


def plate(thickness):
    """Triangles of a plate."""
    corners = [(x, y, z) for x in (0, 0.5) for y in (0, 0.5)
               for z in (0, thickness)]
    for face in ("013", "032", "467", "475", "045", "051", "237", "276",
                 "026", "064", "157", "173"):
        yield tuple(corners[int(c)] for c in face)


def seed(case, triangles):
    """Seeds a body of a binary STL."""
    triangles = list(triangles)
    with open(os.path.join(case.path, "a.stl"), "wb") as stream:
        stream.write(b"fine".ljust(80) + struct.pack("<I", len(triangles)))
        for t in triangles:
            stream.write(struct.pack("<12fH", 0, 0, 0,
                                     *(x for p in t for x in p), 0))
    case.run("seedObjects")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.Case(
        os.path.join(folder, "case"), box=(0, 0, 0, 1, 1, 1),
        cells=(20, 20, 20), shapes=SHAPE.format("a.stl"),
        placements="a { type listed; shape a; "
        "objects ({ centre (0.5 0.5 0.5); }); }")
    case.run("blockMesh")
    report.attempt("sphere", seed, case, sphere(0.4))
    seconds = case.seconds.get("seedObjects", 1e9)
    report.check("a sphere of 50,000 triangles is meshed in seconds",
                 seconds < LIMIT, f"{seconds:.1f} s")
    try:
        seed(case, plate(0.01/20))
    except RuntimeError:
        pass
    seconds = case.seconds["seedObjects"]
    refused(report, "a plate of a hundredth of a cell is refused", case,
            "seedObjects", ("seedObjectsDict", "'shape'", "'nodeSpacing'"))
    report.check("it is refused at once", seconds < 5, f"{seconds:.1f} s")


if __name__ == "__main__":
    main(sys.argv[1])
