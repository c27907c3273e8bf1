#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects whose motion is prescribed, and objects at one place: what cannot be
ends in an error that names them.

    motions.py FOLDER
"""

import os
import re
import sys

import fsiCase
import results
from refused import refused


def check_prescribed(report, folder):
    """Objects whose motions are prescribed: one with a velocity of its own, and
    one that is driven into another."""
    motions = {"still": "fixed;", "mover": "translating; velocity (1 0 0);"}
    case = fsiCase.Case(
        os.path.join(folder, "prescribed"), cells=(32, 32), deltaT=0.02,
        endTime=0.4, shapes=" ".join(
            f"{name} {{ shape {{ type circle; radius 0.15; }} material "
            f"{{ type rigid; density 1; }} motion {{ type {motion} }} }}"
            for name, motion in motions.items()),
        placements="a { type listed; objects ("
                   "{ shape mover; centre (0.3 0.5 0); } "
                   "{ shape still; centre (0.7 0.5 0); }); }")
    if report.attempt("set-up of prescribed objects", case.set_up):
        refused(report, "prescribed objects driven into each other", case,
                "fsiPisoFoam", ("FATAL ERROR", "Objects 0 of shape mover",
                                "1 of shape still", "overlap at time"))
    case.values["placements"] = case.values["placements"].replace(
        "0.7 0.5 0);", "0.7 0.5 0); velocity (0.1 0 0);")
    case.write()
    refused(report, "velocity of a prescribed object", case, "seedObjects",
            ("FATAL IO ERROR", "seedObjectsDict", "'velocity'", "placement a",
             "object 1", "motion"))


def check_fed(report, folder):
    """A feed whose objects have a prescribed motion that does not bring them
    in, or not at the velocity of the feed; one that is too fast for a step."""
    known = "prescribed motion"
    for name, motion, speed, texts in (
            ("outward", "translating; velocity (-1 0 0)", 1,
             (known, "(-1 0 0)")),
            ("fixed", "fixed", 1, (known, "(0 0 0)")),
            ("slower", "translating; velocity (0.5 0 0)", 1,
             (known, "(0.5 0 0)")),
            ("fast", "free", 1e6, ("1000000", "half of the domain"))):
        case = fsiCase.Case(
            os.path.join(folder, "fed" + name), cells=(32, 32), endTime=0.02,
            open={"left": ("type fixedValue; value uniform (1 0 0);",
                           "type zeroGradient;"),
                  "right": ("type zeroGradient;",
                            "type fixedValue; value uniform 0;")},
            shapes="disc { shape { type circle; radius 0.1; } material { type "
                   f"rigid; density 1; }} motion {{ type {motion}; }} }}",
            properties="boundaries { feed { left { shape disc; rate 1; "
                       f"velocity ({speed} 0 0); }} }} }}\n")
        if report.attempt(f"set-up of a feed, {name}", case.set_up):
            refused(report, f"velocity of a feed, {name}", case, "fsiPisoFoam",
                    ("FATAL IO ERROR", "'velocity'", "left", *texts))


def check_one_place(report, folder):
    """Two free objects at one place are named at the start."""
    for cells, material, properties in (
            ((32, 32), "E 100;", ""), ((16, 16, 16), "E 100;", ""),
            ((16, 16, 16), "type membrane; shearModulus 1;",
             "contact { law { type none; } }")):
        plane = len(cells) == 2
        case = fsiCase.Case(
            os.path.join(folder, f"place{len(cells)}"), cells=cells,
            properties=properties,
            box=(0, 0, 1, 1) if plane else (0, 0, 0, 1, 1, 1), endTime=0.02,
            shapes=f"a {{ shape {{ type {'circle' if plane else 'sphere'}; "
                   f"radius 0.15; }} material {{ density 1; {material} }} }}",
            placements="a { type listed; shape a; objects ({ centre "
                       f"(0.3 0.5 {0 if plane else 0.5}); }} {{ centre "
                       f"(0.7 0.5 {0 if plane else 0.5}); }}); }}")
        if not report.attempt("set-up of two objects", case.set_up):
            continue
        name = os.path.join(case.path, "0/uniform/fsiObjects/a")
        with open(name, encoding="ascii") as stream:
            text = stream.read()
        found = re.search(r"(positions\s+List<scalar>\s+\d+\s*\()([^)]*)",
                          text)
        numbers = found.group(2).split()
        half = numbers[:len(numbers)//2]
        text = (text[:found.start(2)] + " ".join(half + half)
                + text[found.end(2):])
        with open(name, "w", encoding="ascii") as stream:
            stream.write(results.without_sums(text))
        refused(report, f"two objects at one place, {len(cells)}D", case,
                "fsiPisoFoam", ("FATAL ERROR", "Objects 0 of shape a and 1 of "
                                "shape a", "overlap at the start"))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_prescribed(report, folder)
    check_fed(report, folder)
    check_one_place(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
