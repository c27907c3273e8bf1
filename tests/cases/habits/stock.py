#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What OpenFOAM's solvers read from a case is done, or refused by name."""

import os
import sys

import fsiCase
import refused
import results

DISC = """disc
{
    shape { type circle; radius 0.15; }
    material { density 2; E 50; }
}
"""
ONE = "one { type listed; shape disc; objects ({ centre (0.5 0.6 0); }); }"

# File, text, what the refusal names
REFUSED = {
    "viscosity": ("constant/transportProperties",
                  "transportModel BirdCareau; nu 0.01;",
                  ["transportModel", "transportProperties", "BirdCareau",
                   "BirdCarreau", "Newtonian", "powerLaw"]),
    "coefficients": ("constant/transportProperties",
                     "transportModel BirdCarreau; nu 0.01;",
                     ["transportProperties", "nu0"]),
    "negativeViscosity": ("constant/transportProperties",
                          "transportModel BirdCarreau; BirdCarreauCoeffs "
                          "{ nu0 -1; nuInf -1; k 1; n 0.5; }",
                          ["transportProperties", "BirdCarreau", "must be"]),
    "turbulence": ("constant/turbulenceProperties",
                   "simulationType RAS; RAS { RASModel kEpsilon; }",
                   ["simulationType", "RAS", "laminar"]),
    "laminarModel": ("constant/turbulenceProperties",
                     "simulationType laminar; laminar { laminarModel Maxwell;"
                     " MaxwellCoeffs { nuM 1; lambda 1; } }",
                     ["laminarModel", "Maxwell"]),
    "MRF": ("constant/MRFProperties", "zone { cellZone all; omega 3; }",
            ["MRFProperties", "zone"]),
    "SRF": ("constant/SRFProperties", "SRFModel rpm;", ["SRFModel"]),
    "movingMesh": ("constant/dynamicMeshDict",
                   "dynamicFvMesh dynamicMotionSolverFvMesh;",
                   ["dynamicFvMesh", "dynamicMeshDict"]),
    "gravity": ("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 -3 0);",
                ["gravity", "constant/g", "remove"]),
}

# The same of files that all cases have: what is replaced, by what
CHANGED = {
    "relaxation": ("system/fvSolution", "PISO {",
                   "relaxationFactors { equations { U 0.7; } } PISO {",
                   ["equations", "'U'", "0.7"]),
    "frozen": ("system/fvSolution", "PISO {", "PISO { frozenFlow yes;",
               ["frozenFlow"]),
    "point": ("system/fvSolution", "PISO {", "PISO { pRefPoint (9 0 0);",
              ["pRefPoint", "fvSolution", "in the mesh"]),
    "cell": ("system/fvSolution", "PISO {", "PISO { pRefCell 99999;",
             ["pRefCell", "fvSolution"]),
    "level": ("system/fvSolution", "PISO {", "PISO { pRefValue 7;",
              ["pRefValue", "pRefCell"]),
    "misspelled": ("system/fvSolution", "PISO {", "PISO { pRefPiont (0 0 0);",
                   ["pRefPiont", "pRefPoint"]),
}


def new_case(folder, **parameters):
    """The case, seeded."""
    options = {"cells": (20, 20), "walls": {"top": "(1 0 0)"}, "shapes": DISC,
               "placements": ONE, "deltaT": 0.005, "endTime": 0.02,
               "writeInterval": 4, "gravity": "(0 -1 0)",
               "writePrecision": 12, **parameters}
    return fsiCase.Case(folder, **options).set_up()


def replace(case, name, old, new):
    """Replaces a text in a file of the case."""
    text = results.read(case.path, name)
    if old not in text:
        raise ValueError(f"no {old} in {name}")
    with open(os.path.join(case.path, name), "w", encoding="ascii") as stream:
        stream.write(text.replace(old, new))


def refusals(report, folder):
    """What would change the flow and is not done."""
    case = new_case(folder)
    for name, (path, text, message) in REFUSED.items():
        whole = os.path.join(folder, path)
        before = results.read(whole) if os.path.exists(whole) else None
        case.file(path, text)
        refused.refused(report, "stock.refused." + name, case, "fsiPisoFoam",
                        message)
        os.remove(whole)
        if before is not None:
            with open(whole, "w", encoding="ascii") as stream:
                stream.write(before)
    for name, (path, old, new, message) in CHANGED.items():
        before = results.read(folder, path)
        replace(case, path, old, new)
        refused.refused(report, "stock.refused." + name, case, "fsiPisoFoam",
                        message)
        with open(os.path.join(folder, path), "w", encoding="ascii") as stream:
            stream.write(before)


def harmless(report, folder):
    """Files that say what is so anyway."""
    case = new_case(folder)
    case.file("constant/turbulenceProperties", "simulationType laminar;")
    case.file("constant/dynamicMeshDict", "dynamicFvMesh staticFvMesh;")
    case.file("constant/MRFProperties", "zone { active no; omega 3; }")
    replace(case, "constant/transportProperties", "nu",
            "transportModel Newtonian;\nnu")
    replace(case, "system/fvSolution", "PISO {",
            "PISO { nCorrectors 2; momentumPredictor no; "
            "nNonOrthogonalCorrectors 0;")
    log = case.run("fsiPisoFoam")
    report.check("stock.harmless",
                 "no meaning here: nCorrectors momentumPredictor (" in log,
                 "not named")


def same_gravity(report, folder):
    """constant/g is gravity as that of fsiProperties."""
    sums = []
    for name in ("properties", "file"):
        case = new_case(os.path.join(folder, name))
        if name == "file":
            replace(case, "constant/fsiProperties", "gravity (0 -1 0);", "")
            case.file("constant/g", "dimensions [0 1 -2 0 0 0 0];\n"
                      "value (0 -1 0);", "uniformDimensionedVectorField")
        case.run("fsiPisoFoam")
        sums.append(results.read(case.path, "0.02/uniform/fsiObjects/disc"))
    report.check("stock.gravityOfFile", sums[0] == sums[1], "another motion")


def pressure_level(report, folder):
    """p has its level, which moves nothing, and a restart goes on with it."""
    without = new_case(os.path.join(folder, "without"))
    without.run("fsiPisoFoam")
    velocity = results.field(without.path, "0.02", "U")
    for name, entry, cell in (("cell", "pRefCell 3;", 3),
                              ("point", "pRefPoint (0.99 0.99 0.02);", 399)):
        case = new_case(os.path.join(folder, name), startFrom="latestTime")
        replace(case, "system/fvSolution", "PISO {",
                f"PISO {{ {entry} pRefValue 7;")
        case.control(endTime=0.01, writeInterval=2, writePrecision=17)
        case.run("fsiPisoFoam")
        case.control(endTime=0.02)
        case.run("fsiPisoFoam")
        level = results.field(case.path, "0.02", "p")[cell]
        report.check(f"stock.level.{name}", abs(level - 7) < 1e-9,
                     f"p is {level}")
        difference = max(abs(a - b) for a, b in zip(
            results.field(case.path, "0.02", "U"), velocity))
        report.check(f"stock.level.{name}.flow", difference < 1e-10,
                     f"U differs by {difference}")
    report.check("stock.level.state", "fsiPressureLevel" in os.listdir(
        os.path.join(case.path, "0.02/uniform")), "it is not written")


POROUS = """porous
{
    type explicitPorositySource;
    explicitPorositySourceCoeffs
    {
        selectionMode all;
        type DarcyForchheimer;
        d (1e3 1e3 1e3);
        f (0 0 0);
        coordinateSystem { origin (0 0 0); e1 (1 0 0); e2 (0 1 0); }
    }
}
"""


def porosity(report, folder):
    """A porous medium slows the flow down."""
    speeds = []
    for name in ("free", "porous"):
        case = new_case(os.path.join(folder, name), gravity="(0 0 0)")
        if name == "porous":
            case.file("constant/fvOptions", POROUS.replace(
                "selectionMode all", "selectionMode cellZone; cellZone block"))
            case.file("system/topoSetDict", "actions ({ name block; type "
                      "cellZoneSet; action new; source boxToCell; "
                      "box (-1 -1 -1) (2 2 2); });")
            case.run("topoSet")
        case.run("fsiPisoFoam")
        U = results.field(case.path, "0.02", "U")
        speeds.append(sum(abs(u) for u in U))
    report.check("stock.porosity", speeds[1] < 0.95*speeds[0], f"{speeds}")


def main():
    report = fsiCase.Report()
    folder = sys.argv[1]
    report.attempt("refusals", refusals, report, os.path.join(folder, "r"))
    report.attempt("harmless", harmless, report, os.path.join(folder, "h"))
    report.attempt("gravity", same_gravity, report, os.path.join(folder, "g"))
    report.attempt("level", pressure_level, report, os.path.join(folder, "l"))
    if os.environ.get("FSI_LINE") != "foundation":
        report.attempt("porosity", porosity, report,
                       os.path.join(folder, "p"))
    return report.failures > 0


if __name__ == "__main__":
    sys.exit(main())
