# SPDX-License-Identifier: GPL-3.0-or-later
"""The correction of the pressure with membranes (doc/theory.md, (4.19)) does
not make errors grow where the flux of a face is not the one of its cells: at
an outlet whose velocity is inletOutlet, and in the film between a body and a
wall that it touches."""

import os

import fsiCase
import results

# Steps over h^2/nu
DIFFUSION = 100

MATERIAL = ("material { type membrane; law neoHookean; density 1; "
            "shearModulus 1; }")

CASES = {
    "outlet": {"cells": (30, 20, 20), "box": (0, 0, 0, 1.5, 1, 1),
               "open": {"left": ("type fixedValue; value uniform (1 0 0);",
                                 "type zeroGradient;"),
                        "right": ("type inletOutlet; inletValue uniform "
                                  "(0 0 0); value uniform (1 0 0);",
                                  "type fixedValue; value uniform 0;")},
               "shapes": f"m {{ shape {{ type sphere; radius 0.2; }} "
                         f"{MATERIAL} }}",
               "placements": "a { type listed; shape m; objects ({ centre "
                             "(0.5 0.5 0.5); }); }"},
    "corner": {"cells": (48, 24), "box": (0, 0, 2, 1), "cyclic": "x",
               "walls": {"top": "(1 0 0)"},
               "shapes": f"m {{ shape {{ type circle; radius 0.15; }} "
                         f"{MATERIAL} }} post {{ shape {{ type circle; radius "
                         "0.3; } material { type rigid; density 1; } motion "
                         "{ type fixed; } }",
               "placements": "a { type listed; shape m; objects ({ centre "
                             "(0.4 0.6 0); }); } b { type listed; shape post; "
                             "objects ({ centre (1.2 0.1 0); }); }"},
}


def check(report, folder):
    """Time errors fall as the flow develops."""
    for name, values in CASES.items():
        h = 1/values["cells"][1]
        step = 0.3*h
        case = fsiCase.Case(
            os.path.join(folder, f"pressure-{name}"),
            viscosity=DIFFUSION*h**2/step, deltaT=step, endTime=40*step,
            properties="coupling { passes 4; }", **values).set_up()
        case.run("fsiPisoFoam")
        errors = [row["timeError"]
                  for row in results.table(case.path, "global.csv")]
        first, last = max(errors[:10]), max(errors[-5:])
        report.check(f"with a membrane the time error falls, {name}",
                     len(errors) == 40 and last < 0.1*first,
                     f"{first:.1e} {last:.1e}")
