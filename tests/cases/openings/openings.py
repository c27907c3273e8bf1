#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies fall onto a side with an opening.

    openings.py FOLDER

One falls through and is removed, one beside the opening is held, one meets the
edge and goes through. On ranks and after a restart it is the same.
"""

import math
import sys

import fsiCase
import results
from sidesWithOpenings import Box

OUT = ("type zeroGradient;", "type fixedValue; value uniform 0;")

# In cells: first and end of the opening, and of all
FIRST, END, CELLS = 10, 22, 32

RADIUS = 0.12

SHAPES = {
    "rigid": "disc { shape { type circle; radius 0.12; } material "
             "{ type rigid; density 3; } }",
    "soft": "disc { shape { type circle; radius 0.12; } material "
            "{ density 3; E 200; } }",
    "sphere": "disc { shape { type sphere; radius 0.12; } material "
              "{ type rigid; density 3; } }",
}

# One above the opening, one beside it, one above its edge
PLACES = ((0.47, 0.2), (0.15, 0.15), (0.66, 0.5))


def vessel(folder, name, shape, **parameters):
    """A vessel, open above, with an opening in its bottom, seeded."""
    space = shape == "sphere"
    cells = 20 if space else CELLS
    first, end = (math.floor(c*cells/CELLS + 0.5) for c in (FIRST, END))
    objects = " ".join(f"{{ centre ({x} {y} {0.5 if space else 0}); }}"
                       for x, y in PLACES)
    options = {
        "box": (0, 0, 0, 1, 1, 1) if space else (0, 0, 1, 1),
        "cells": (cells,)*(3 if space else 2),
        "openings": {"hole": ("bottom", (first, 0, first),
                              (end, cells, end))},
        "open": {"hole": OUT, "top": OUT}, "shapes": SHAPES[shape],
        "viscosity": 0.01, "gravity": "(0 -4 0)",
        "placements": "discs { type listed; shape disc; wallGap 0; "
                      f"minimumGap 0; objects ({objects}); }}",
        "deltaT": 0.005, "endTime": 1.5, "writePrecision": 17,
        "writeInterval": 20, "p_tolerance": 1e-10, "U_tolerance": 1e-11,
        "startFrom": "latestTime", **parameters,
    }
    return Box(f"{folder}/{name}", **options).set_up()


def inside(polygon, x, y):
    """Is a point inside a polygon?"""
    return all((bx - ax)*(y - ay) > (by - ay)*(x - ax)
               for (ax, ay), (bx, by) in results.edges(polygon))


def check_ranks(report, folder, case, shape, end, *split):
    """Ranks give at a time what one gives."""
    n = math.prod(split)
    ranks = vessel(folder, f"{shape}{n}", shape, endTime=end)
    ranks.decompose(*split)
    report.attempt(f"{shape} on {n} ranks", ranks.run, "fsiPisoFoam", ranks=n)
    one, other = (results.state(c.path, str(end), rank)
                  for c, rank in ((case, ""), (ranks, "processor0")))
    report.check(f"{shape}: as many are left on {n} ranks",
                 list(one) == list(other), list(other))
    worst = max(math.dist(p, q) for i in set(one).intersection(other)
                for p, q in zip(one[i][1], other[i][1]))
    report.check(f"{shape}: {n} ranks change nothing", worst < 1e-7, worst)


def check_fall(report, folder, shape):
    """One disc passes, one is held, and one rolls over the edge."""
    # The force on soft discs begins three cells away
    case = report.attempt(f"{shape}, set-up", vessel, folder, shape, shape,
                          endTime=2.1 if shape == "soft" else 1.5)
    if case is None or report.attempt(shape, case.run, "fsiPisoFoam") is None:
        return None
    rows = results.table(case.path, "global.csv")
    report.check(f"{shape}: two leave, one is held",
                 (rows[-1]["objects"], rows[-1]["removed"]) == (1, 2),
                 rows[-1])
    log = results.read(case.path, "log.fsiPisoFoam")
    report.check(f"{shape}: they leave through the opening",
                 log.count("left through hole") == 2, "no")
    held = min(results.state(case.path, results.times(case.path)[-1])[1][1],
               key=lambda p: p[1])
    report.check(f"{shape}: it is held at the wall", 0 < held[1] < 0.05, held)
    report.check(f"{shape}: objects are sound", report.attempt(
        f"{shape}, checkObjects", case.run, "checkObjects"), "no")
    if shape == "sphere":
        check_ranks(report, folder, case, shape, 0.3, 2, 1, 1)
        return case
    edges = (FIRST/CELLS, 0), (END/CELLS, 0)
    bad = [(t, i) for t in results.times(case.path)[1:]
           for i, polygon in results.outlines(case.path, t).items()
           for edge in edges if inside(polygon, *edge)]
    report.check(f"{shape}: the edge is in no disc", not bad, bad)
    return case


def check_equal(report, folder, case, shape):
    """A restart and ranks give what one run gives."""
    parts = vessel(folder, f"{shape}Parts", shape)
    for end in (0.5, 1.5):
        parts.control(endTime=end)
        report.attempt(f"{shape} to {end}", parts.run, "fsiPisoFoam")
    one, other = (results.state(c.path, "1.5") for c in (case, parts))
    report.check(f"{shape}: a restart changes nothing", one == other, "it does")
    for split in ((2, 1), (1, 3)):
        check_ranks(report, folder, case, shape, 0.7, *split)


def check_feed(report, folder):
    """Discs are fed through an opening in the top, and leave below."""
    case = report.attempt(
        "feed, set-up", vessel, folder, "feed", "rigid", placements="",
        endTime=1.5, openings={
            "hole": ("bottom", (FIRST, 0), (END, 32)),
            "inlet": ("top", (4, 0), (16, 32))},
        open={"hole": OUT, "inlet": (
            "type fixedValue; value uniform (0 -0.5 0);",
            "type zeroGradient;")},
        properties="boundaries { feed { inlet { shape disc; rate 2; seed 3; "
                   "velocity (0 -0.5 0); minimumGap 0.03; } } }\n")
    if case is None or report.attempt("feed", case.run, "fsiPisoFoam") is None:
        return
    last = results.table(case.path, "global.csv")[-1]
    report.check("discs are fed through an opening", last["fed"] == 3, last)
    report.check("fed discs are sound", report.attempt(
        "checkObjects", case.run, "checkObjects"), "no")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for shape in SHAPES:
        case = check_fall(report, folder, shape)
        if case is not None and shape == "rigid":
            check_equal(report, folder, case, shape)
    check_feed(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
