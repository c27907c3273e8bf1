#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Twenty steps, or ten and a restart for ten more: the same state.

    restart.py FOLDER

A disc with a Kelvin-Voigt law, a star and a fixed disc in a driven cavity.
"""

import math
import os
import sys

import fsiCase
import results

# Of the box: with the history of the faces' velocities (the default), and
# without it, where a restart is bitwise exact
TOLERANCE = {"default": 0, "faceHistory none": 0}

SHAPES = """
disc
{
    shape { type circle; radius 0.1; }
    material { density 1.1; E 20; springLaw { type KelvinVoigt; viscosity 1; } }
}
star
{
    shape { type star; radius 0.12; amplitude 0.2; points 5; }
    material { density 1.1; E 50; }
}
post
{
    shape { type circle; radius 0.08; }
    material { density 1; E 100; }
    motion { type fixed; }
}
"""

PLACEMENTS = """
discs { type listed; shape disc; objects ({ centre (0.3 0.75 0); }); }
stars { type listed; shape star; objects ({ centre (0.65 0.7 0); }); }
posts { type listed; shape post; objects ({ centre (0.5 0.3 0); }); }
"""


def solve(folder, name, ends, properties):
    """Runs the case to each end after the other; the case folder."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(48, 48),
        walls={"top": "(1 0 0)"}, shapes=SHAPES, placements=PLACEMENTS,
        properties=properties,
        deltaT=0.01, writeInterval=10, writePrecision=17,
        p_tolerance=1e-12, U_tolerance=1e-12,
    ).set_up()
    for end in ends:
        case.control(startFrom="latestTime", endTime=end)
        case.run("fsiPisoFoam")
    return case.path


def compare(report, folder, name):
    """Checks one set of properties."""
    properties = "" if name == "default" else name + ";\n"
    whole = report.attempt(f"whole run, {name}", solve, folder, "whole",
                           (0.2,), properties)
    parts = report.attempt(f"run in parts, {name}", solve, folder, "parts",
                           (0.1, 0.2), properties)
    if whole is None or parts is None:
        return

    first = results.state(whole, "0.1"), results.state(parts, "0.1")
    report.check(f"two runs are bitwise the same, {name}",
                 first[0] == first[1], "states at t = 0.1 differ")
    one, other = (results.state(case, "0.2") for case in (whole, parts))
    report.check(f"the same objects, {name}", list(one) == list(other),
                 f"{list(one)} and {list(other)}")

    def difference(a, b):
        return max(math.dist(p, q) for i in a
                   for p, q in zip(a[i][1], b[i][1]))

    moved = difference(one, first[0])
    report.check(f"the objects move, {name}", moved > 1e-3, f"{moved:.2e}")
    error = difference(one, other)
    print(f"    nodes differ by {error:.2e}, moved by {moved:.2e}")
    report.check(f"a restart gives the same state, {name}",
                 error <= TOLERANCE[name], f"nodes differ by {error:.2e}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for name in TOLERANCE:
        compare(report, folder, name)


if __name__ == "__main__":
    main(sys.argv[1])
