#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Twenty steps, or ten and a restart for ten more: the same state.

    restart.py FOLDER

A disc with a Kelvin-Voigt law, a star and a fixed disc in a driven cavity; red
cells in a periodic channel, with a driving force.
"""

import filecmp
import math
import os
import re
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


def capillary(folder, name, ends):
    """Runs the tutorial of the red cells to each end; the last state."""
    case = fsiCase.tutorial("redCells", os.path.join(folder, name),
                            startFrom="latestTime", writeInterval=0.005)
    for end in ends:
        fsiCase.set_entry(os.path.join(case, "system/controlDict"),
                          "endTime", end)
        fsiCase.run(case, "fsiPisoFoam")
    return os.path.join(case, str(ends[-1]))


def files(folder):
    """All files below a folder, by their paths in it."""
    return sorted(os.path.relpath(os.path.join(path, name), folder)
                  for path, _, names in os.walk(folder) for name in names)


def compare_capillaries(report, folder):
    """All files of the last state, of cells that have crossed the seam."""
    whole = capillary(folder, "capillary", (0.01,))
    parts = capillary(folder, "capillaryInParts", (0.005, 0.01))
    population = results.read(whole, "uniform", "fsiPopulation")
    crossed = re.findall(r"(?m)^\d+ (\(.*\))$", population)
    report.check("cells that crossed the seam did so once",
                 len(crossed) > 0 and set(crossed) == {"(1 0 0)"}, crossed)
    names = files(whole)
    report.check("two states have the same files",
                 names == files(parts), (names, files(parts)))
    differ = filecmp.cmpfiles(whole, parts, names, shallow=False)[1:]
    report.check("a restart of membranes is bitwise the same",
                 differ == ([], []), differ)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    for name in TOLERANCE:
        compare(report, folder, name)
    compare_capillaries(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
