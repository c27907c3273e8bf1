#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields, controls and meshes that have no meaning end fsiPisoFoam in an error
that names file and entry; a time step that collapses and a surface that cuts
itself end it as well; the
function object solverInfo finds our fields.

    badFields.py FOLDER
"""

import os
import re
import sys

import fsiCase
from refused import refused
import results

DISC = "disc { shape { type circle; radius 0.15; } material { density 1.1; "\
    "E 20; } }"
ONE = "a { type listed; shape disc; objects ({ centre (0.5 0.5 0); }); }"
POST = """post { shape { type polygon; file "post.csv"; }
    material { type rigid; density 1; } motion { type fixed; } }"""
CLOSES = "-0.3,-0.7\n0.2,-0.7\n0.2,0.7\n-0.3,0.7\n"
FREE = "-0.15,-0.49\n0.15,-0.49\n0.15,0.49\n-0.15,0.49\n"
BEHIND = "a { type listed; shape post; objects ({ centre (0.15 0.5 0); }); }"

INLET = {"left": ("type fixedValue; value uniform (1 0 0);",
                  "type zeroGradient;"),
         "right": ("type zeroGradient;", "type fixedValue; value uniform 0;")}

# What is wrong: file, pattern, replacement, texts of the message
EDITS = [
    ("absurd speed of a wall", "0/U", r"(top.*uniform )\(0 0 0\)",
     r"\1(1e300 0 0)", ("0/U", "'top'", "1e15")),
    ("absurd velocity", "0/U", r"internalField uniform \(0 0 0\)",
     "internalField uniform (0 1e300 0)", ("0/U", "internalField")),
    ("a dictionary for values", "0/p", "boundaryField", "internalField",
     ("0/p", "internalField", "must be the value of a field")),
    ("U with the dimensions of p", "0/U", r"\[0 1 -1", "[0 2 -2",
     ("0/U", "'dimensions'", "a velocity")),
    ("p in pascals", "0/p", r"\[0 2 -2", "[1 -1 -2",
     ("0/p", "'dimensions'", "over a density")),
    ("another class in the header of U", "0/U", "volVectorField",
     "volScalarField", ("0/U", "volVectorField")),
    ("a patch without a condition of U", "0/U", r"top \{", "tpo {",
     ("0/U", "top")),
    ("a patch without a condition of p", "0/p", r"top \{", "tpo {",
     ("0/p", "top")),
    ("a condition without a type", "0/U", r"(top \{ )type \w+;", r"\1",
     ("0/U", "top", "type")),
    ("an unknown condition", "0/U", r"(top \{ type )\w+", r"\1noSlop",
     ("0/U", "top", "noSlop")),
    ("no values", "0/U", "internalField", "internalFeild",
     ("0/U", "internalField")),
    ("fixedFluxPressure", "0/p", r"(top.*type )zeroGradient",
     r"\1fixedFluxPressure; value uniform 0", ("0/p", "'top'",
                                                "zeroGradient")),
    ("pressure given at a wall", "0/p", r"(top.*type )zeroGradient",
     r"\1fixedValue; value uniform 0", ("0/p", "'top'", "wall")),
    ("a wall that moves along its normal", "0/U", r"(top.*uniform )\(0 0 0\)",
     r"\1(1 1e-3 0)", ("0/U", "'top'", "through the patch", "type patch")),
    ("absurd viscosity", "constant/transportProperties", r"nu .*;",
     "nu 1e300;", ("transportProperties", "'nu'", "1e15")),
    ("no solvers", "system/fvSolution", r"\bsolvers\b", "sovlers",
     ("fvSolution", "'solvers'")),
    ("no solver of U", "system/fvSolution", r"\bU\b", "V",
     ("fvSolution", "'U'")),
    ("tolerance above 1", "system/fvSolution", r"tolerance \S+;",
     "tolerance 1e10;", ("fvSolution", "'tolerance'", "< 1")),
    ("negative tolerance", "system/fvSolution", r"tolerance \S+;",
     "tolerance -1;", ("fvSolution", "'tolerance'", ">= 0")),
    ("unknown entry of a solver", "system/fvSolution", r"relTol 0;",
     "wCycleFrom 2;", ("FATAL IO ERROR", "fvSolution", "'wCycleFrom'",
                       "gatherCells")),
    ("relTol above 1", "system/fvSolution", r"relTol 0;", "relTol 2;",
     ("fvSolution", "'relTol'", "< 1")),
]

# Two blocks that touch but are not merged
BLOCKS = """
vertices ((0 0 0) (0.5 0 0) (0.5 1 0) (0 1 0)
    (0 0 0.05) (0.5 0 0.05) (0.5 1 0.05) (0 1 0.05)
    (0.5 0 0) (1 0 0) (1 1 0) (0.5 1 0)
    (0.5 0 0.05) (1 0 0.05) (1 1 0.05) (0.5 1 0.05));
blocks (hex (0 1 2 3 4 5 6 7) (10 20 1) simpleGrading (1 1 1)
    hex (8 9 10 11 12 13 14 15) (10 20 1) simpleGrading (1 1 1));
boundary
(
    top { type wall; faces ((3 7 6 2) (11 15 14 10)); }
    bottom { type wall; faces ((0 1 5 4) (8 9 13 12)); }
    left { type wall; faces ((0 4 7 3)); }
    right { type wall; faces ((9 10 14 13)); }
    middle { type wall; faces ((1 2 6 5) (8 12 15 11)); }
    frontAndBack { type empty; faces ((0 3 2 1) (4 5 6 7)
        (8 11 10 9) (12 13 14 15)); }
);
"""


def check_edits(report, case):
    """Each edit of a sound case."""
    for name, path, pattern, change, texts in EDITS:
        text = results.read(case.path, path)
        new = re.sub(pattern, change, text, count=1)
        with open(os.path.join(case.path, path), "w",
                  encoding="ascii") as stream:
            stream.write(new)
        refused(report, name, case, "fsiPisoFoam",
                texts if new != text else ("edited",))
        case.write()


def check_inlet(report, folder):
    """A fixed object in front of the whole inlet."""
    case = fsiCase.Case(os.path.join(folder, "inlet"), cells=(20, 20),
                        endTime=0.01, open=INLET, shapes=POST,
                        placements=BEHIND)
    with open(os.path.join(case.path, "post.csv"), "w",
              encoding="ascii") as stream:
        stream.write(CLOSES)
    if report.attempt("set-up of the inlet", case.set_up):
        refused(report, "blocked inlet", case, "fsiPisoFoam",
                ("0/U", "'left'", "block"))


def check_patches(report, folder):
    """A patch that objects may pass and the fluid not."""
    case = fsiCase.Case(
        os.path.join(folder, "patches"), cells=(20, 20), endTime=0.01,
        open={"left": ("type noSlip;", "type zeroGradient;")},
        shapes=DISC, placements=ONE)
    if report.attempt("set-up of a wall of type patch", case.set_up):
        refused(report, "a wall of type patch", case, "fsiPisoFoam",
                ("0/U", "'left'", "type wall"))


def check_dead_end(report, folder):
    """A fixed object closes the channel, some way behind the inlet."""
    for name, more, texts in (
            ("a channel closed by a fixed object", "motion { type fixed; }",
             ("0/U", "'left'", "m3/s", "nowhere")),
            ("a channel closed by a free object", "", None)):
        case = fsiCase.Case(
            os.path.join(folder, "dead"), cells=(20, 20), endTime=0.02,
            open=INLET, shapes=POST.replace("motion { type fixed; }", more),
            placements=BEHIND.replace("0.15 0.5", "0.6 0.5"))
        with open(os.path.join(case.path, "post.csv"), "w",
                  encoding="ascii") as stream:
            stream.write(CLOSES if more else FREE)
        if report.attempt("set-up of " + name, case.set_up):
            if texts:
                refused(report, name, case, "fsiPisoFoam", texts)
            else:
                report.check(name, case.run("fsiPisoFoam").rstrip().endswith(
                    "End"))


def check_crossing(report, folder):
    """A heavy soft disc falls flat; the run ends, or goes on if it may."""
    for choice in ("stop", "warn"):
        case = fsiCase.Case(
            os.path.join(folder, choice), cells=(40, 40), deltaT=0.01,
            adjustTimeStep="yes", maxDeltaT=0.01, endTime=2, writeInterval=20,
            gravity="(0 -1 0)", shapes=DISC.replace("1.1; E 20", "1000; E 100"),
            placements=ONE, properties=f"output {{ crossing {choice}; }}\n")
        if not report.attempt("set-up of the falling disc", case.set_up):
            continue
        if choice == "stop":
            refused(report, "a surface that cuts itself ends the run", case,
                    "fsiPisoFoam",
                    ("At time", "cut themselves: 1(0)", "crossing warn"))
        else:
            log = case.run("fsiPisoFoam")
            report.check("crossing warn: the run goes on",
                         "cut themselves: 1(0)" in log
                         and log.rstrip().endswith("End"), log[-300:])


def check_walls(report, folder):
    """Blocks that are not merged."""
    case = fsiCase.Case(os.path.join(folder, "walls"), cells=(20, 20),
                        shapes=DISC, placements=ONE)
    case.append("system/blockMeshDict", BLOCKS)
    case.run("blockMesh")
    refused(report, "wall inside the domain", case, "seedObjects",
            ("middle", "inside the mesh's box", "fixed"))


def check_collapse(report, case):
    """A time step below the smallest that is allowed."""
    case.values["walls"] = {"top": "(1 0 0)"}
    case.write()
    case.control(adjustTimeStep="yes", maxCo=0.01, deltaT=0.001,
                 maxDeltaT=0.01, minDeltaT=0.0009, endTime=1)
    refused(report, "a time step that collapses", case, "fsiPisoFoam",
            ("At time", "the time step falls", "m/s", "minDeltaT"))


def check_solver_info(report, case):
    """solverInfo has lines with residuals."""
    case.control(
        endTime=0.02,
        functions="{ info { type solverInfo; fields (U p); "
        "libs (\"libutilityFunctionObjects.so\"); } }")
    path = os.path.join(case.path, "system/controlDict")
    text = results.read(path).replace("} };", "} }")
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)
    case.run("fsiPisoFoam")
    rows = results.read(case.path, "postProcessing/info/0/solverInfo.dat")
    last = rows.strip().split("\n")[-1].split()
    report.check("solverInfo finds U and p",
                 "cartesianMG" in last and "fsiSOR" in last
                 and float(last[0]) > 0.015, rows[-400:])


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.Case(os.path.join(folder, "case"), cells=(20, 20),
                        endTime=0.01, shapes=DISC, placements=ONE)
    if report.attempt("set-up", case.set_up) is None:
        return
    report.attempt("sound fields are accepted", case.run, "fsiPisoFoam")
    check_edits(report, case)
    report.attempt("solverInfo", check_solver_info, report, case)
    case.control(functions="{ }")
    report.attempt("blocked inlet", check_inlet, report, folder)
    report.attempt("patches", check_patches, report, folder)
    report.attempt("dead end", check_dead_end, report, folder)
    report.attempt("crossing", check_crossing, report, folder)
    report.attempt("walls inside", check_walls, report, folder)
    report.attempt("collapse", check_collapse, report, case)


if __name__ == "__main__":
    main(sys.argv[1])
