#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Twenty steps, or ten and a restart for ten more: the same state.

    restart.py FOLDER

A disc with a Kelvin-Voigt law, a star, a fixed disc and one that oscillates in
a driven cavity; red cells in a periodic channel, with a driving force; in
binary, spheroids of a shape that is only fed into a box, beside a shape whose
objects have left.
"""

import filecmp
import math
import os
import re
import struct
import sys

import fsiCase
import results
import smallCase

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
piston
{
    shape { type circle; radius 0.08; }
    material { density 1; type rigid; }
    motion { type oscillating; amplitude (0.02 0 0); frequency 3; }
}
"""

PLACEMENTS = """
discs { type listed; shape disc; objects ({ centre (0.3 0.75 0); }); }
stars { type listed; shape star; objects ({ centre (0.65 0.7 0); }); }
posts { type listed; shape post; objects ({ centre (0.5 0.3 0); }); }
pistons { type listed; shape piston; objects ({ centre (0.8 0.2 0); }); }
"""

FED = """
a { shape { type ellipsoid; semiAxes (0.18 0.13 0.13); }
    material { density 1000; E 1e4; } }
b { shape { type sphere; radius 0.13; } material { density 1000; E 1e4; } }
"""

OPEN = {"left": ("type fixedValue; value uniform (1 0 0);",
                 "type zeroGradient;"),
        "right": ("type zeroGradient;", "type fixedValue; value uniform 0;")}


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


def compare(report, folder):
    """Checks that the run in parts ends where the whole one does."""
    whole = report.attempt("whole run", solve, folder, "whole", (0.2,))
    parts = report.attempt("run in parts", solve, folder, "parts", (0.1, 0.2))
    if whole is None or parts is None:
        return

    first = results.state(whole, "0.1"), results.state(parts, "0.1")
    report.check("two runs are bitwise the same",
                 first[0] == first[1], "states at t = 0.1 differ")
    one, other = (results.state(case, "0.2") for case in (whole, parts))
    report.check("the same objects", list(one) == list(other),
                 f"{list(one)} and {list(other)}")

    def difference(a, b):
        return max(math.dist(p, q) for i in a
                   for p, q in zip(a[i][1], b[i][1]))

    moved = difference(one, first[0])
    report.check("the objects move", moved > 1e-3, f"{moved:.2e}")
    error = difference(one, other)
    print(f"    nodes differ by {error:.2e}, moved by {moved:.2e}")
    report.check("a restart gives the same state",
                 error == 0, f"nodes differ by {error:.2e}")


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
    with open(os.path.join(whole, "uniform/fsiObjects/redCell"),
              "rb") as stream:
        content = stream.read()
    match = re.search(rb"\nperiods\s+List<scalar>\s+(\d+)\s*\(", content)
    periods = struct.unpack_from(f"{int(match.group(1))}d", content,
                                 match.end())
    report.check("cells that crossed the seam did so once",
                 set(periods[::3]) == {0, 1} and not any(
                     periods[1::3] + periods[2::3]), periods)
    names = files(whole)
    report.check("two states have the same files",
                 names == files(parts), (names, files(parts)))
    differ = filecmp.cmpfiles(whole, parts, names, shallow=False)[1:]
    report.check("a restart of membranes is bitwise the same",
                 differ == ([], []), differ)


def fed_box(folder, name, ends):
    """Runs a box that is fed to each end; the case."""
    case = fsiCase.Case(
        os.path.join(folder, name), box=(0, 0, 0, 1, 1, 1),
        cells=(12, 12, 12), open=OPEN, density=1000, viscosity=0.01,
        shapes=FED, placements="b { type listed; shape b; velocity (1 0 0);"
        " objects ({ centre (0.8 0.5 0.5); }); }",
        properties="boundaries { feed { left { shape a; rate 3;"
        " velocity (1 0 0); velocityPerturbation 0.2; } } }\n",
        deltaT=0.02, writeInterval=10, writeFormat="binary").set_up()
    for end in ends:
        case.control(startFrom="latestTime", endTime=end)
        case.run("fsiPisoFoam")
    return case


def compare_fed(report, folder):
    """All files of the last state, after a feed beyond the restart."""
    whole = fed_box(folder, "fed", (1.4,))
    parts = fed_box(folder, "fedInParts", (0.8, 1.4))
    feeds = [row["fed"] for row in results.table(whole.path, "global.csv")]
    report.check("objects are fed before and after the restart",
                 0 < feeds[39] < feeds[-1], (feeds[39], feeds[-1]))
    left = [row["removed"] for row in results.table(whole.path, "global.csv")]
    report.check("a shape has no objects left", left[39] == 1, left[39])
    one, other = (smallCase.result(os.path.join(case.path, "1.4"))
                  for case in (whole, parts))
    differ = [name for name in sorted(set(one) | set(other))
              if one.get(name) != other.get(name)]
    report.check("a restart of a fed box is bitwise the same", not differ,
                 differ)
    text = parts.run("checkObjects")
    report.check("the objects of all times are sound",
                 "Objects are sound" in text, text[-300:])


def check_bytes(report, folder):
    """A velocity of the state whose bytes look like the end of a list's type
    and a negative number of values before a bracket."""
    speed = struct.unpack("<d", b"\0\0>-(\x9a\x99?")[0]
    case = smallCase.small_case(
        os.path.join(folder, "bytes"), writeFormat="binary", placements=
        smallCase.PLACEMENTS.replace(
            "shape disc;", f"shape disc; velocity ({speed!r} 0 0);"))
    found = any(b">-(" in content for content in smallCase.result(
        os.path.join(case.path, "0")).values())
    case.run("fsiPisoFoam", "-dry-run")
    report.check("bytes of numbers are no lists", found)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    compare(report, folder)
    compare_capillaries(report, folder)
    report.attempt("fed box", compare_fed, report, folder)
    report.attempt("bytes of numbers are no lists", check_bytes, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
