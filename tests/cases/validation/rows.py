#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of tutorials/validation that take seconds.

    rows.py FOLDER
"""

import itertools
import math
import os
import sys

import fsiCase

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../../../tutorials/validation"))
import capsuleInTube  # noqa: E402
import common  # noqa: E402
import cylinder  # noqa: E402
import discs  # noqa: E402
import fixedWalls  # noqa: E402
import lubrication  # noqa: E402
import softDisc  # noqa: E402

# Drag and speed at 8 cells per diameter; the table asks for 2 % at 16. Immersed
# boundaries of other codes reach 8 % at 10 and 5 % at 20
COARSE = 0.08

# Elastic energy of the soft disc in the vortex at h = 1/64: 0.0022 where cut
# faces keep their history, 0.0020 where they do not, 0.0028 at 1/256
KEPT = 0.0021

# Drag of DFG 2D-1 at 10 cells per diameter: the interval of the benchmark's
# participants, 5.57 to 5.59, grown to what the table asks for at 20. With
# OpenFOAM's limiter of the faces' history it is 1.8 % off, and depends on the
# time step
FIXED = 0.01

# A disc that moves at 8 cells per diameter; solids4foam is 5 % off at 10
MOVING = 0.05


def check(report, row, tolerance=None):
    """One row, with the tolerance that its table has or with another."""
    tolerance = tolerance or row.tolerance
    error = abs(row.value - row.reference)
    print(f"    {row.what}, {row.grid}: {row.value:.6g}")
    report.check(f"{row.what}, {row.grid}", error <= tolerance,
                 f"{row.value:.6g}, not {row.reference} +- {tolerance}")


def check_order(report, coarse, fine):
    """The error falls at least with first order."""
    errors = [abs(row.value - row.reference) for row in (coarse, fine)]
    order = math.log2(errors[0]/errors[1])
    print(f"    {fine.what}: {coarse.value:.6g}, {fine.value:.6g}, "
          f"order {order:.2f}")
    report.check(f"{fine.what}: first order at least", order >= 1,
                 f"order {order:.2f}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    common.FOLDER = folder

    def rows(function, number):
        return report.attempt(
            function.__name__,
            lambda: list(itertools.islice(function(), number))) or []

    # A sphere of 8 cells, tubes of 10 and 8
    for function in (fixedWalls.spheres, fixedWalls.tube, capsuleInTube.stiff):
        for row in rows(function, 1):
            check(report, row)

    still = rows(softDisc.static, 4)
    for row in still[:2]:
        check(report, row)
    if still:
        check_order(report, *still[2:])

    drags = rows(discs.container, 2)
    for row, tolerance in zip(drags, (COARSE, None)):
        check(report, row, tolerance)
    if drags:
        check_order(report, *drags)

    vortex = rows(softDisc.taylor_green, 3)
    for row in vortex[2:]:
        check(report, row)
    for row in vortex[1:2]:
        print(f"    {row.what}, {row.grid}: {row.value:.6g}")
        report.check("cut faces keep their history", row.value > KEPT,
                     f"elastic energy {row.value:.6g}, not above {KEPT}")
    # One disc and a wall, two discs; a large step must not make films lag,
    # whose pressure then holds the bodies too little or for too long
    for bodies, step in ((1, 10), (1, 40), (2, 10), (2, 40)):
        row = report.attempt("film", lubrication.approach, 2, bodies, step)
        if row:
            check(report, row)
    for row in rows(discs.stokes, 1):
        check(report, row, COARSE)
    for row in rows(cylinder.translating, 1):
        check(report, row, MOVING)
    for row in rows(cylinder.steady, 1):
        check(report, row, FIXED*row.reference)


if __name__ == "__main__":
    main(sys.argv[1])
