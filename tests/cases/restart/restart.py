#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Twenty steps, or ten and a restart for ten more: the same state.

    restart.py FOLDER

A soft disc with a Kelvin-Voigt law, a star and a fixed disc in a driven cavity,
binary files.
"""

import math
import os
import sys

import fsiCase
import results

# Of the box: what the fluid's restart may change. See check_restart
TOLERANCE = 1e-6

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


def solve(folder, name, ends):
    """Runs the case to each end after the other; the case folder."""
    case = fsiCase.Case(
        os.path.join(folder, name), cells=(48, 48),
        walls={"top": "(1 0 0)"}, shapes=SHAPES, placements=PLACEMENTS,
        deltaT=0.01, writeInterval=10, writePrecision=17,
        p_tolerance=1e-12, U_tolerance=1e-12,
    ).set_up()
    for end in ends:
        case.control(startFrom="latestTime", endTime=end)
        case.run("fsiPisoFoam")
    return case.path


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    whole = report.attempt("whole run", solve, folder, "whole", (0.2,))
    parts = report.attempt("run in parts", solve, folder, "parts", (0.1, 0.2))
    if whole is None or parts is None:
        return

    first = results.state(whole, "0.1"), results.state(parts, "0.1")
    report.check("two runs are bitwise the same", first[0] == first[1],
                 "states at t = 0.1 differ")
    one, other = (results.state(case, "0.2") for case in (whole, parts))
    report.check("the same objects", list(one) == list(other),
                 f"{list(one)} and {list(other)}")
    moved = max(math.dist(p, q) for i in one
                for p, q in zip(one[i][1], first[0][i][1]))
    report.check("the objects move", moved > 1e-3, f"by {moved:.2e}")
    error = max(math.dist(p, q) for i in one
                for p, q in zip(one[i][1], other[i][1]))
    print(f"    nodes differ by {error:.2e}, moved by {moved:.2e}; bitwise "
          f"{'the same' if one == other else 'different'}")
    report.check("a restart gives the same state", error <= TOLERANCE,
                 f"nodes differ by {error:.2e}")


if __name__ == "__main__":
    main(sys.argv[1])
