#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Free bodies in three dimensions, 8 cells across: a sphere turns with half the
shear rate, a rigid one as a stiff one, and an elastic one that swings gains no
energy and keeps its volume.

    spheres.py FOLDER
"""

import os
import sys

import fsiCase

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../../../tutorials/validation"))
import common  # noqa: E402
import oscillatingSphere  # noqa: E402
import shearBox  # noqa: E402

CELLS = 4

# Walls and neighbours at eight radii from one another; the table asks for 3 %
# at 8 cells per radius and ten radii
TURNING = 0.06

# A rigid body and a stiff one
SAME = 0.01


def turn(report):
    """Both kinds of sphere in the same shear."""
    rates = {}
    for kind in shearBox.KINDS:
        found = report.attempt(kind, shearBox.turning, kind, CELLS, 3, 8)
        if found is None:
            return
        rates[kind] = found[0]
        print(f"    {kind}: {found[0]:.5f} of the shear rate")
        report.check(f"a {kind} sphere turns with half the shear rate",
                     abs(found[0]/0.5 - 1) < TURNING, f"{found[0]}")
    ratio = rates["rigid"]/rates["stiff"]
    report.check("a rigid sphere turns as a stiff one", abs(ratio - 1) < SAME,
                 f"{ratio} of its rate")


def swing(report):
    """Half a period of the elastic sphere."""
    case = oscillatingSphere.swing(CELLS, 2)
    minutes = case.solve_only()
    for row in oscillatingSphere.what_is_kept(case, minutes):
        print(f"    {row.what}: {row.value:.3g}")
        report.check(row.what, row.passed, f"{row.value}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    common.FOLDER = folder
    turn(report)
    report.attempt("swinging", swing, report)


if __name__ == "__main__":
    main(sys.argv[1])
