#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A number that is too large for the machine ends a program in a FOAM FATAL IO
ERROR that names the file and the key, and in no signal. So do numbers that the
machine has, but not their powers, and those beyond a bound with a reason.

    largeNumbers.py FOLDER
"""

import os
import re
import sys

import fsiCase
from refused import refused
import results
from smallCase import DISC_AND_CELL, small_case

# Entries that become a number too large for the machine: file, key, program
NUMBERS = [
    ("system/controlDict", "deltaT", "fsiPisoFoam"),
    ("system/controlDict", "endTime", "fsiPisoFoam"),
    ("system/controlDict", "writeInterval", "checkObjects"),
    ("system/fvSolution", "tolerance", "fsiPisoFoam"),
    ("constant/transportProperties", "nu", "fsiPisoFoam"),
    ("constant/fsiProperties", "fluidDensity", "fsiPisoFoam"),
    ("0/U", "internalField", "fsiPisoFoam"),
    ("0/p", "internalField", "fsiPisoFoam"),
    ("system/controlDict", "endTime", "seedObjects"),
    ("system/seedObjectsDict", "density", "seedObjects"),
]

# Numbers of materials
MODULI = ["E", "density", "shearModulus", "bendingModulus", "innerViscosity",
          "viscosity"]

# Entries of the contact law, and texts of the message; E is 20 Pa
LAWS = [("stiffness 1e12", ("'stiffness'", "at most 20000000 Pa", "least E")),
        ("stiffness 1e300", ("'stiffness'", "1e15")),
        ("type Morse; adhesionEnergy 1e300", ("'adhesionEnergy'", "1e15"))]


def write(path, text):
    """Writes a file."""
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)


def check_numbers(report, case):
    """Numbers that are too large, in the files of which OpenFOAM reads all; and
    a folder with the name of one, which is no time."""
    os.mkdir(os.path.join(case.path, "1e400"))
    for path, key, program in NUMBERS:
        text = results.read(case.path, path)
        new = re.sub(rf"({key}\b[^;]*?)[-0-9.][-+0-9.e]*(\W*[;}}])",
                     r"\g<1>1e400\g<2>", text, count=1)
        write(os.path.join(case.path, path), new)
        refused(report, f"{key} 1e400 in {path}, {program}", case, program,
                ("FATAL IO ERROR", os.path.basename(path), key))
        write(os.path.join(case.path, path), text)
    case.run("fsiPisoFoam")
    os.rmdir(os.path.join(case.path, "1e400"))


def with_number(text, key, value):
    """The text with another number of the key."""
    return re.sub(rf"\b{key} [-0-9.e]+;", f"{key} {value};", text, count=1)


def check_moduli(report, case):
    """Numbers of materials that overflow are refused, and those just below
    the bound end in no signal."""
    path = "system/seedObjectsDict"
    text = results.read(case.path, path)
    case.control(writeInterval=1000000)
    for key in MODULI:
        write(os.path.join(case.path, path), with_number(text, key, 1e300))
        refused(report, f"{key} 1e300", case, "seedObjects",
                ("FATAL IO ERROR", "seedObjectsDict", f"'{key}'", "1e15"))
        write(os.path.join(case.path, path), with_number(text, key, 9e14))
        try:
            case.run("seedObjects")
            case.run("fsiPisoFoam")
            error = ""
        except RuntimeError as caught:
            error = str(caught)
        report.check(f"{key} 9e14: no signal", "ended with -" not in error,
                     error)
    write(os.path.join(case.path, path), text)
    case.run("seedObjects")


def check_laws(report, case):
    """A stiffness far above that of the bodies, and others."""
    for text, texts in LAWS:
        case.values["properties"] = f"contact {{ law {{ {text}; }} }}\n"
        case.write()
        refused(report, text, case, "fsiPisoFoam",
                ("FATAL IO ERROR", "fsiProperties", *texts))
    case.values["properties"] = ""
    case.write()


def check_contrast(report, case):
    """A fluid inside a membrane that is 1e12 times less or 1e6 times more
    viscous than that around."""
    shapes = case.values["shapes"]
    for value in (1e-14, 1e4):
        case.values["shapes"] = with_number(
            shapes, "innerViscosity", value)
        case.write()
        case.run("seedObjects")
        refused(report, f"innerViscosity {value}", case, "fsiPisoFoam",
                ("FATAL ERROR", "constant/fsiObjects/cell", "'innerViscosity'",
                 "to 100 Pa s, 0.0001 to 10000 times"))
    case.values["shapes"] = shapes
    case.write()
    case.run("seedObjects")


def check_period(report, folder):
    """A disc, or a sheet, that is longer than the period of cyclic sides."""
    for shape in ("disc", "cell"):
        case = fsiCase.Case(
            os.path.join(folder, "period"), box=(0, 0, 0.25, 1),
            cells=(16, 64), cyclic="x", shapes=DISC_AND_CELL.replace(
                "0.15", "0.1" if shape == "cell" else "0.15", 1),
            placements="a { type listed; shape disc; objects "
                       "({ centre (0.125 0.5 0); }); }")
        case.run("blockMesh")
        refused(report, f"a {shape} longer than the period", case,
                "seedObjects", ("FATAL IO ERROR", "seedObjectsDict", "'shape'",
                                f"shapes.{shape}", "0.3 m", "0.25 m"))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = report.attempt("set-up", small_case, os.path.join(folder, "case"),
                          endTime=0.01)
    if case:
        for check in (check_moduli, check_laws, check_contrast, check_numbers):
            report.attempt(check.__name__, check, report, case)
    report.attempt("periods", check_period, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
