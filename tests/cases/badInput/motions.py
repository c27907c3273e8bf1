#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects whose motion is prescribed, functions of time, and objects at one
place: what cannot be ends in an error that names them.

    motions.py FOLDER
"""

import os
import re
import sys

import fsiCase
import results
from refused import refused

# Functions of time that are wrong, and texts of the message
FUNCTIONS = {
    "unknown": ("tabel ((0 (0 0 0)))", ("tabel",)),
    "without its file": ('{ type tableFile; file "nowhere.dat"; }',
                         ("nowhere.dat", "Cannot open")),
    "without the name of its file": ("{ type tableFile; }", ("'file'",)),
    "of numbers": ("table ((0 1) (1 2))", ("3 components",)),
    "of two components": ("constant (1 2)", ("3 components",)),
    "that is a number": ("1", ("3 components",)),
    "without a row": ("table ()", ("empty",)),
    "without an end": ("constant (1e200 0 0)", ("1e15",)),
    "whose times go back": ("table ((1 (0 0 0)) (0 (1 0 0)))", ("order",)),
}


def check_functions(report, folder):
    """Functions of time that cannot be, and loads."""
    wrong = {f"a function {name}": (
        f"motion {{ type function; displacement {text}; }}",
        ("'displacement'", "table", "constant", *texts))
             for name, (text, texts) in FUNCTIONS.items()}
    wrong["a force of a word"] = (
        "motion { type free; force strong; }", ("'force'", "strong", "table"))
    wrong["a load of an unknown type"] = (
        "motion { type free; loads { a { type trp; } } }",
        ("trp", "trap", "loads.a"))
    wrong["a load without its stiffness"] = (
        "motion { type free; loads { a { type trap; place (0 0 0); } } }",
        ("'stiffness'", "loads.a"))
    wrong["a pull of a word"] = (
        "motion { type free; pulls { right { type halfSpace; normal (1 0 0); "
        "force strong; } } }", ("'force'", "pulls.right", "strong", "table"))
    case = fsiCase.Case(
        os.path.join(folder, "functions"), cells=(32, 32),
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.5 0.5 0); }); }")
    case.run("blockMesh")
    for name, (text, texts) in wrong.items():
        case.values["shapes"] = (
            "disc { shape { type circle; radius 0.15; } material { type rigid; "
            f"density 1; }} {text} }}")
        case.write()
        refused(report, name, case, "seedObjects", (
            "FATAL IO ERROR", "seedObjectsDict", "disc.motion", *texts))


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


def check_membrane(report, folder):
    """A membrane with a velocity of its own, and a very heavy one."""
    case = fsiCase.Case(
        os.path.join(folder, "membrane"), cells=(16, 16), deltaT=1e-3,
        endTime=1e-3, shapes="sheet { shape { type circle; radius 0.25; } "
        "material { type membrane; density 2; law neoHookean; shearModulus "
        "0.1; } }", placements="a { type listed; shape sheet; objects "
        "({ centre (0.5 0.5 0); velocity (1 0 0); }); }")
    case.run("blockMesh")
    refused(report, "velocity of a membrane", case, "seedObjects",
            ("FATAL IO ERROR", "seedObjectsDict", "'velocity'", "placement a",
             "membrane", "0/U"))
    case.values["placements"] = case.values["placements"].replace(
        "velocity (1 0 0);", "")
    case.write()
    case.run("seedObjects")
    log = case.run("fsiPisoFoam")
    report.check("a heavy membrane is warned of", "2 times the density" in log
                 and "shape sheet" in log, log[-500:])


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
            ((32, 32), "type rigid;", ""), ((16, 16, 16), "type rigid;", ""),
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
        refused(report, f"two objects at one place, {len(cells)}D, "
                f"{material.split(';')[0]}", case,
                "fsiPisoFoam", ("FATAL ERROR", "Objects 0 of shape a and 1 of "
                                "shape a", "overlap at the start"))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("functions", check_functions, report, folder)
    check_membrane(report, folder)
    check_prescribed(report, folder)
    check_fed(report, folder)
    check_one_place(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
