#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A damaged file of a case's state, shapes or mesh ends the run in an error
that names file and entry, whether or not the file still has its check sums;
missing restart files are noticed, and so are damaged tables and ranks that
hold different objects.

    badState.py FOLDER
"""

import glob
import os
import re
import subprocess
import sys

import fsiCase
import results
from damaged import check_killed, copy_of, failure, write
from smallCase import DISC_AND_CELL

PLACEMENTS = """
discs { type listed; shape disc; objects ({ centre (0.3 0.75 0); }
    { centre (0.3 0.3 0); }); }
cells { type listed; shape cell; objects ({ centre (0.7 0.7 0); }); }
"""

STATE = "0.02/uniform/fsiObjects/disc"
SHAPE = "constant/fsiObjects/disc"
COUNTS = "0.02/uniform/fsiPopulation"

MESH = "constant/polyMesh/"

OLD_ID = r"(objectIds\s+(?:List<label>\s+)?\d+\s*\(\s*)\d"

# What is wrong: file, pattern, replacement, the entry that is named
EDITS = [
    (STATE, OLD_ID, r"\g<1>7", "objectIds"),
    (STATE, OLD_ID, r"\g<1>1", "objectIds"),
    (STATE, OLD_ID, r"\g<1>-1", "objectIds"),
    (STATE, r"shape\s+disc", "shape foo", "shape"),
    (STATE, r"motion\s*\{\s*\}", "motion ball;", "motion"),
    (STATE, r"(positions\s+List<scalar>\s+\d+\s*\(\s*)\S+", r"\g<1>1e400",
     "positions"),
    (STATE, r"(positions\s+List<scalar>\s+\d+\s*\(\s*)\S+", r"\g<1>nan",
     "positions"),
    (STATE, r"(positions\s+List<scalar>\s+\d+\s*\(\s*)\S+", r"\g<1>1e3",
     "positions"),
    (STATE, r"(positions\s+List<scalar>\s+)\d+", r"\g<1>999999999",
     "positions"),
    (STATE, r"(positions\s+List<scalar>\s+)\d+", r"\g<1>-5", "positions"),
    (STATE, r"(?s)velocities .*?;", "", "velocities"),
    (STATE, r"(?s)meanLoad .*?;", "", "meanLoad"),
    (STATE, r"(springStates\s+List<scalar>\s+\d+\s*\(\s*)\S+",
     r"\g<1>1e200", "springStates"),
    (SHAPE, r"nDims\s+2", "nDims 258", "nDims"),
    (SHAPE, r"name\s+disc", "name foo", "name"),
    (SHAPE, r"thickness\s+\S+;", "thickness 7;", "nodeMasses"),
    (SHAPE, r"density\s+\S+;", "density 7;", "nodeMasses"),
    (SHAPE, r"nBoundaryNodes\s+\d+", "nBoundaryNodes -5", "nBoundaryNodes"),
    (SHAPE, r"nBoundaryNodes\s+\d+", "nBoundaryNodes 5", "faces"),
    (SHAPE, r"(faces\s+(?:List<label>\s+)?\d+\s*\(\s*)\d+", r"\g<1>99999",
     "faces"),
    (SHAPE, r"(elements\s+(?:List<label>\s+)?\d+\s*\(\s*)\d+", r"\g<1>-7",
     "elements"),
    (SHAPE, r"(nodeMasses\s+(?:List<scalar>\s+)?\d+\s*\(\s*)\S+", r"\g<1>0",
     "nodeMasses"),
    (SHAPE, r"nodeSpacing\s+\S+;", "nodeSpacing -1;", "nodeSpacing"),
    (COUNTS, r"nDims\s+2", "nDims 258", "nDims"),
    (COUNTS, r"planeZ\s+\S+;", "planeZ 55;", "planeZ"),
    (COUNTS, r"nextObjectId\s+\d", "nextObjectId 1", "objectIds"),
    (COUNTS, r"nextObjectId\s+\d;", "nextObjectId { }", "nextObjectId"),
]

# The same of the mesh's files and of headers: what is named
FILE_EDITS = [
    (MESH + "points", r"\(\S+ ", "(nan ", "line"),
    (MESH + "points", r"\(\S+ ", "(1e300 ", "point 0"),
    (MESH + "points", r"\n\d+\n\(", "\n2147483647\n(", "memory"),
    (MESH + "faces", r"4\(\d+ ", "4(-1 ", "face 0"),
    (MESH + "faces", r"4\(\d+ ", "4(99999 ", "face 0"),
    (MESH + "faces", r"4\((\d+) (\d+) ", r"4(\1 \1 ", "face 0"),
    (MESH + "owner", r"\n0\n", "\n-3\n", "face 0"),
    (MESH + "owner", r"\n0\n", "\n2147483647\n", "face 0"),
    (MESH + "owner", r"(?s)(.*)\n\d+\n\)", r"\1\n700\n)", "cell 576"),
    (MESH + "neighbour", r"\n1\n", "\n0\n", "face 0"),
    (MESH + "boundary", r"startFace\s+\d+", "startFace 7", "patch 'left'"),
    (MESH + "boundary", r"nFaces\s+\d+", "nFaces -7", "patch 'left'"),
    (MESH + "boundary", r"startFace\s+\d+;", "", "startFace"),
    (MESH + "boundary", r"type\s+wall;", "", "patch 'left'"),
    (MESH + "boundary", r"1\(wall\)", "2147483647(wall)", "patch 'left'"),
    (MESH + "owner", r"version .*;", "version 1e300;", "'version'"),
    ("0.02/U", r"version .*;", "version -2147483648;", "'version'"),
    ("constant/fsiProperties", r"version .*;", "version 1e9;", "'version'"),
    ("constant/fsiProperties", r"fluidDensity .*;", "fluidDensity { }",
     "'fluidDensity'"),
    ("0.02/p", r"version .*;", "version nan;", "'version'"),
    ("system/controlDict", r"version .*;", "version 1e9;", "'version'"),
]

# Of those above, the ones that only a check sum can notice
SILENT = [
    (STATE, r"(velocities\s+List<scalar>\s+\d+\s*\(\s*\S+\s+)\S+",
     r"\g<1>0.125", "velocities"),
    (SHAPE, r"nodeSpacing\s+\S+;", "nodeSpacing 0.011;", "nodeSpacing"),
    (SHAPE, r"\bE\s+20;", "E 21;", "material"),
]


def check_edits(report, case, folder):
    """Each edit, with check sums and without."""
    wrong = os.path.join(folder, "wrong")
    for path, pattern, change, entry in EDITS + SILENT:
        for sums in (True, False):
            if not sums and (path, pattern, change, entry) in SILENT:
                continue
            copy_of(case, wrong)
            text = results.read(wrong, path)
            new = re.sub(pattern, change, text, count=1)
            if new == text:
                report.check(f"{entry}: edited", False, pattern)
                continue
            write(os.path.join(wrong, path),
                  new if sums else results.without_sums(new))
            message = failure(wrong)
            name = (f"{os.path.basename(path)}, {pattern} to {change}, "
                    f"{'with' if sums else 'without'} sums")
            start = message.startswith("--> FOAM FATAL")
            # With sums, what was changed is named
            named = re.search(rf"'{entry}'", message) or (
                sums and re.search(r"'(?:\w+)'", message))
            report.check(name, start and named
                         and os.path.basename(path) in message,
                         " ".join(message.split())[:400])


def check_files(report, case, folder):
    """Each edit of a mesh, and of a header."""
    for path, pattern, change, named in FILE_EDITS:
        wrong = copy_of(case, os.path.join(folder, "wrong"))
        text = results.read(wrong, path)
        start = 0 if "version" in pattern else max(text.find("// * *"), 0)
        new = text[:start] + re.sub(pattern, change, text[start:], count=1)
        write(os.path.join(wrong, path), new)
        message = failure(wrong)
        report.check(f"{path}, {pattern} to {change}",
                     new != text and message.startswith("--> FOAM FATAL")
                     and named in message
                     and os.path.basename(path) in message,
                     " ".join(message.split())[:300])


def check_missing(report, case, folder):
    """Restart files that are not there, or cut."""
    wrong = os.path.join(folder, "wrong")
    for name in ("phi", "faceHistory", "velocityRate", "pressureRate"):
        copy_of(case, wrong)
        os.remove(os.path.join(wrong, "0.02", name))
        log = failure(wrong)
        report.check(f"{name} missing: a warning",
                     "Warning" in log and f'/{name}" is missing' in log
                     and log.rstrip().endswith("End"), log[-300:])
    path = copy_of(case, wrong) + "/0.02/uniform/fsiRestart"
    text = results.without_sums(results.read(path))
    new = re.sub(r"fields\s[^(]*\(", "fields (poreVolume ", text)
    write(path, new)
    log = failure(wrong)
    report.check("a user's field is not missed", new != text
                 and "Warning" not in log and "\nEnd" in log, log[-300:])


def check_tables(report, case, folder):
    """Damaged lines of global.csv."""
    for name, change in (
            ("cut", lambda rows: rows[:-1] + [rows[-1][:30]]),
            ("nan", lambda rows: rows[:-1]
             + [re.sub(r",[^,]*,", ",nan,", rows[-1], count=1)])):
        wrong = copy_of(case, os.path.join(folder, "wrong"))
        path = glob.glob(os.path.join(
            wrong, "postProcessing/fsiObjects/*/global.csv"))[0]
        rows = results.read(path).split("\n")[:-1]
        write(path, "\n".join(change(rows)) + "\n")
        try:
            fsiCase.run(wrong, "checkObjects")
        except RuntimeError:
            pass
        log = results.read(wrong, "log.checkObjects")
        report.check(f"a {name} line of global.csv is a fault",
                     "Objects are not sound" in log and "Line 3 of" in log,
                     log[-300:])


def check_ranks(report, case, folder):
    """One rank's state is that of another time, or misses a field."""
    two = copy_of(case, os.path.join(folder, "ranks"))
    write(os.path.join(two, "system/decomposeParDict"),
          "FoamFile { version 2.0; format ascii; class dictionary; object "
          "decomposeParDict; }\nnumberOfSubdomains 2; method simple; "
          "simpleCoeffs { n (2 1 1); delta 0.001; }\n")
    fsiCase.run(two, "decomposePar", "-latestTime")
    rank = os.path.join(two, "processor1")
    os.remove(os.path.join(rank, "0.02/phi"))
    log = failure(two, ranks=2)
    report.check("phi missing on one rank", "FATAL" in log and "phi" in log,
                 log[-300:])
    fsiCase.run(two, "decomposePar", "-latestTime", "-force")
    # decomposePar makes a link of the folder
    os.remove(os.path.join(rank, "0.02/uniform"))
    log = failure(two, ranks=2)
    report.check("the first rank's state is that of all", "\nEnd\n" in log,
                 log[-300:])


def check_lock(report, case, folder):
    """A second run in the folder is refused."""
    two = copy_of(case, os.path.join(folder, "two"))
    fsiCase.set_entry(os.path.join(two, "system/controlDict"), "endTime", 900)
    with open(os.path.join(two, "log.first"), "w", encoding="ascii") as log:
        with subprocess.Popen(["fsiPisoFoam", "-case", two], stdout=log,
                              stderr=log) as first:
            path = os.path.join(two, "log.first")
            while first.poll() is None and "Time = " not in results.read(path):
                pass
            message = failure(two)
            # Not the folder: the run may be making a file in it
            for table in glob.glob(os.path.join(
                    two, "postProcessing/fsiObjects/*/global.csv")):
                os.remove(table)
            size = os.path.getsize(path)
            while (first.poll() is None
                   and os.path.getsize(path) < size + 4000):
                pass
            first.kill()
    report.check("a second run in the folder is refused",
                 "Another run" in message, message[-300:])
    report.check("removed tables are reported",
                 "Somebody removed" in results.read(path),
                 results.read(path)[-600:])


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.Case(
        os.path.join(folder, "case"), cells=(24, 24), deltaT=0.01,
        endTime=0.02, writeInterval=2, walls={"top": "(1 0 0)"},
        shapes=DISC_AND_CELL, placements=PLACEMENTS, writePrecision=17)
    if report.attempt("set-up", case.set_up) is None:
        return
    if report.attempt("run", case.run, "fsiPisoFoam") is None:
        return
    case.control(startFrom="latestTime", endTime=0.03)
    log = fsiCase.run(copy_of(case.path, os.path.join(folder, "good")),
                      "fsiPisoFoam")
    report.check("the sound state goes on", log.rstrip().endswith("End")
                 and "Warning" not in log, log[-300:])
    for part in (check_edits, check_files, check_missing, check_killed,
                 check_tables, check_ranks, check_lock):
        report.attempt(part.__name__, part, report, case.path, folder)


if __name__ == "__main__":
    main(sys.argv[1])
