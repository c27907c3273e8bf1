#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""checkObjects: passes a short run of the first tutorial, and names each fault
put into copies of its last time; the same with open sides, where discs are
fed and leave.

    faults.py FOLDER
"""

import os
import re
import shutil
import sys

import fsiCase
import openChannel
import results

SHAPE = "uniform/fsiObjects/disc"
END = 0.02


def state_file(case, time=None):
    """Path of the state of the discs at a time, the last one if not given."""
    return os.path.join(case, time or results.times(case)[-1], SHAPE)


def edit(case, change, time=None):
    """Applies change to the positions of the discs: lists of x and y of the
    nodes of each disc."""
    path = state_file(case, time)
    text = results.without_sums(results.read(path))
    flat = results.numbers(text, "positions")
    n_columns = 2*len(results.numbers(text, "objectIds"))
    n = len(flat)//n_columns
    columns = [flat[i*n:(i + 1)*n] for i in range(n_columns)]
    change(columns)
    values = "\n".join(repr(v) for column in columns for v in column)
    text = re.sub(r"(?ms)^positions\s.*?;",
                  f"positions List<scalar> {len(flat)}({values});", text)
    write(path, text)


def write(path, text):
    """Writes a file."""
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)


def shift(dx, dy=0, disc=1):
    """A disc moved; the second one if nothing else is given."""
    def change(columns):
        columns[2*disc][:] = [x + dx for x in columns[2*disc]]
        columns[2*disc + 1][:] = [y + dy for y in columns[2*disc + 1]]
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
    text = results.without_sums(results.read(shapes))
    write(shapes, re.sub(r"nextObjectId\s+2;", "nextObjectId 3;", text))


FEED = ("boundaries { feed { left { shape disc; velocity (1 0 0); "
        "startTime 0.1; rate 1; } } }\n")


def beyond(case):
    """Times at which a disc is wholly beyond the outflow and beyond the
    inflow; all of it in cells of 1/24."""
    out, fed = [], []
    for time in results.times(case):
        for polygon in results.outlines(case, time).values():
            if min(x for x, _ in polygon) > 2:
                out.append(time)
            if max(x for x, _ in polygon) < 0:
                fed.append(time)
    return out, fed


def change_entry(case, name, pattern, replacement):
    """Replaces the last match of a pattern in a file of a case."""
    text = results.without_sums(results.read(case, name))
    last = list(re.finditer(pattern, text))[-1]
    write(os.path.join(case, name),
          text[:last.start()] + last.expand(replacement) + text[last.end():])


GLOBAL = "postProcessing/fsiObjects/0/global.csv"


def open_faults(out, fed, end):
    """Faults where sides are open: what is named, the time, what is done."""
    h = 1/24
    left = f"{end}/uniform/fsiBoundaries"
    return {
        "Objects are outside the domain: 0":
            (out, lambda case: edit(case, shift(3*h, disc=0), out)),
        "Objects are outside the domain: 1":
            (fed, lambda case: edit(case, shift(0, 0.5), fed)),
        "Objects are lost: 0 left, missing are 1":
            (end, lambda case: change_entry(case, left, r"\b1\b(?=[ \d]*\))",
                                            "0")),
        "Objects are lost: 1 at t":
            ("0", lambda case: change_entry(
                case, GLOBAL, r"(?<=\n)([^,]*,[^,]*),1,", r"\1,0,")),
        "Time steps are short, median over step: 2.5 at t":
            ("0", lambda case: change_entry(
                case, GLOBAL, r"(?<=\n)([^,]*),[^,]*,", r"\1,0.004,")),
    }


def check_open(report, folder):
    """Discs that leave and are fed are sound; other faults are noticed."""
    case = openChannel.channel(
        folder, "open", ((1.8, 0.5, 1),), walls=openChannel.PLUG,
        endTime=0.5, writeInterval=1, properties=FEED)
    if report.attempt("open sides", case.run, "fsiPisoFoam") is None:
        return
    path = case.path
    out, fed = beyond(path)
    end = results.times(path)[-1]
    report.check("a disc leaves and one is fed", out and fed, f"{out} {fed}")
    report.attempt("sound objects at open sides", fsiCase.run, path,
                   "checkObjects", "-maxSpeed", "1.5", "-minStep", "0.99")
    expect_fault(report, path, "Objects are too fast", "-maxSpeed", "0.9",
                 "-time", "0")
    expect_fault(report, path, "Fluid is too fast", "-maxSpeed", "0.9",
                 "-time", "0")

    for i, (name, (time, change)) in enumerate(
            open_faults(out[-1], fed[0], end).items()):
        wrong = os.path.join(folder, f"open{i}")
        shutil.copytree(path, wrong)
        change(wrong)
        expect_fault(report, wrong, name, "-time", time, "-minStep", "0.5")


def close_sides(path):
    """Makes walls of all patches that are not empty."""
    with open(path, encoding="ascii") as stream:
        text = stream.read()
    with open(path, "w", encoding="ascii") as stream:
        stream.write(re.sub(r"(\btype\s+)(?!empty\b)\w+;", r"\1wall;", text))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    check_open(report, folder)
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
    close_sides(os.path.join(wrong, "constant/polyMesh/boundary"))
    expect_fault(report, wrong, "Objects are lost", "-latestTime")


if __name__ == "__main__":
    main(sys.argv[1])
