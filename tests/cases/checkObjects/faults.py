#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""checkObjects: passes a short run of the first tutorial, and names each fault
put into copies of its last time.

    faults.py FOLDER
"""

import os
import re
import shutil
import sys

import fsiCase
import results

SHAPE = "uniform/fsiObjects/disc"
END = 0.02


def state_file(case):
    """Path of the state of the discs at the last time."""
    return os.path.join(case, results.times(case)[-1], SHAPE)


def edit(case, change):
    """Applies change to the positions of the discs: lists of x and y of the
    nodes of each disc."""
    path = state_file(case)
    text = results.read(path)
    flat = results.numbers(text, "positions")
    n = len(flat)//4
    columns = [flat[i*n:(i + 1)*n] for i in range(4)]
    change(columns)
    values = "\n".join(repr(v) for column in columns for v in column)
    text = re.sub(r"(?ms)^positions\s.*?;",
                  f"positions List<scalar> {4*n}({values});", text)
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)


def shift(distance):
    """The second disc moved in x."""
    def change(columns):
        columns[2][:] = [x + distance for x in columns[2]]
    return change


def swell(columns):
    """The first disc 1 % wider."""
    centre = sum(columns[0])/len(columns[0])
    columns[0][:] = [centre + 1.01*(x - centre) for x in columns[0]]


def cross(columns):
    """A node of the first disc beyond the other side of it."""
    for column in columns[:2]:
        column[0] = 3*sum(column)/len(column) - 2*column[0]


FAULTS = {
    "Objects overlap": shift(-0.25),
    "Objects are outside the domain": shift(0.5),
    "Areas are off": swell,
    "Outlines cross themselves": cross,
}


def expect_fault(report, case, name, *options):
    """checkObjects must fail and name the fault."""
    try:
        fsiCase.run(case, "checkObjects", *options)
        report.check(f"{name}: noticed", False, "checkObjects passes")
    except RuntimeError:
        text = results.read(case, "log.checkObjects")
        report.check(f"{name}: noticed",
                     name in text and "Objects are not sound" in text,
                     text[-300:])


def lose(path):
    """One disc less than there ever were, in a box of walls."""
    shapes = os.path.join(os.path.dirname(os.path.dirname(path)),
                          "fsiPopulation")
    text = results.read(shapes)
    with open(shapes, "w", encoding="ascii") as stream:
        stream.write(re.sub(r"nextObjectId\s+2;", "nextObjectId 3;", text))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.tutorial(
        "01-twoDiscs", os.path.join(folder, "case"), endTime=END,
        writeInterval=END/2, writeFormat="ascii")
    fsiCase.run(case, "fsiPisoFoam")
    text = report.attempt("sound objects", fsiCase.run, case, "checkObjects")
    report.check("sound objects pass at all times",
                 text is not None and text.count("Time = ") == 3
                 and "0 faults in 3 times" in text, str(text)[-300:])

    for name, change in FAULTS.items():
        wrong = os.path.join(folder, name.replace(" ", ""))
        shutil.copytree(case, wrong)
        edit(wrong, change)
        expect_fault(report, wrong, name)
        fsiCase.run(wrong, "checkObjects", "-time", f"0:{END/2}")

    wrong = os.path.join(folder, "lost")
    shutil.copytree(case, wrong)
    lose(state_file(wrong))
    fsiCase.set_entry(os.path.join(wrong, "constant/polyMesh/boundary"),
                      "type", "wall")
    expect_fault(report, wrong, "Objects are lost", "-latestTime")


if __name__ == "__main__":
    main(sys.argv[1])
