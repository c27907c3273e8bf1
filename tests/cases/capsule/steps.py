# SPDX-License-Identifier: GPL-3.0-or-later
"""A capsule in shear flow: steps that are too long, and what is refused."""

import re

import results
from shearCase import STEP, STIFF, VISCOSITY, capsule

# With two cells to the radius it is 99.8 at rest, where 100 is allowed
LONG = {**STIFF, "deltaT": 0.0745, "endTime": 1}


def refused(report, folder):
    """What does not work is named."""
    for name, more, words in (
            ("coupling", {"properties": "coupling { type none; }"},
             "is a membrane inside the fluid"),
            ("kernel", {"properties": "membranes { kernel 5; }"}, "kernel"),
            ("step", {"deltaT": 4, "endTime": 8}, "too long for the membranes"),
            ("drop", {"law": "drop", "modulus": "tension", "deltaT": 2.7,
                      "endTime": 5.4}, "too long for the membranes"),
            ("stretch", LONG, "as they are stretched"),
            ("order", {"time_scheme": "backward"},
             "take Euler for ddtSchemes in system/fvSchemes")):
        case = capsule(folder, name, cells=2, **more)
        try:
            case.run("fsiPisoFoam")
            text = "it ran"
        except RuntimeError as error:
            text = str(error)
        report.check(f"refused: {name}", words in text, text)


def stiff(report, folder, plane=False, contrast=1, step=STEP):
    """A stiff sheet with implicit forces beside explicit ones with a fifth of
    the step: what the step changes of a soft sheet is 2 % too."""
    rows = []
    material = f"{STIFF['material']} innerViscosity {contrast*VISCOSITY};"
    for name, parts in (("explicit", 5), ("implicit", 1)):
        case = capsule(folder, f"{name}{contrast}", plane=plane,
                       deltaT=step/parts, **{**STIFF, "material": material})
        case.run("fsiPisoFoam")
        rows.append(results.table(case.path, "objects.csv")[-1])
    exact, found = rows
    keys = ("phase",) if plane else ("stretch", "phaseZ")
    for key in ("deformation", *keys):
        report.check(f"implicit forces, contrast {contrast}: {key} as with a "
                     "short step", abs(found[key]/exact[key] - 1) < 0.02,
                     f"{found[key]:.4f} {exact[key]:.4f}")


def adjusted(report, folder):
    """Steps that adjust themselves get shorter as a membrane is stretched."""
    case = capsule(folder, "adjusted", cells=2, adjustTimeStep="yes", **LONG)
    log = case.run("fsiPisoFoam")
    report.check("the summary tells that membranes held the step",
                 re.search(r"held by .*membranes \(", log), log[-900:])
    first, *_, last = results.table(case.path, "global.csv")
    report.check("steps follow the stretch", last["time"] > 0.98
                 and last["deltaT"] < 0.9*first["deltaT"], str(last))


def drop(report, folder):
    """Steps of a drop get so short that its forces are explicit: with implicit
    ones of the first step it is torn."""
    case = capsule(folder, "adjustedDrop", cells=4, plane=True, law="drop",
                   modulus="tension", capillary=0.01, deltaT=0.03, endTime=1.5,
                   adjustTimeStep="yes", maxDeltaT=0.03, maxCo=1)
    case.run("fsiPisoFoam")
    D = [row["deformation"] for row in results.table(case.path, "objects.csv")]
    report.check("steps of a drop", 0.008 < D[-1] < 0.016, str(D[::5]))
