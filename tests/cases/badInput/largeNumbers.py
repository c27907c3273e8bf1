#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A number that is too large for the machine ends a program in a FOAM FATAL IO
ERROR that names the file and the key, and in no signal.

    largeNumbers.py FOLDER
"""

import os
import re
import sys

import fsiCase
from refused import refused
import results
from smallCase import small_case

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


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = report.attempt("set-up", small_case, os.path.join(folder, "case"),
                          endTime=0.01)
    if case:
        report.attempt("numbers", check_numbers, report, case)


if __name__ == "__main__":
    main(sys.argv[1])
